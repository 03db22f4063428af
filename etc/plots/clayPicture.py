#!/usr/bin/env pvpython
# bentoFoam, GPL-3.0-or-later
"""Picture of a clayFoam case: platelets coloured by speed, over the solid
fraction and the velocity of the water in the middle plane.

usage: etc/plots/pvrun pvpython etc/plots/clayPicture.py CASE OUT.png [TIME]
"""
import os
import sys

from paraview.simple import *

case, out = os.path.abspath(sys.argv[1]), sys.argv[2]

foam = os.path.join(case, 'case.foam')
open(foam, 'a').close()

reader = OpenFOAMReader(FileName=foam)
reader.CaseType = 'Reconstructed Case'
reader.SkipZeroTime = 0
reader.UpdatePipelineInformation()
reader.MeshRegions = ['internalMesh', 'lagrangian/clay']
time = float(sys.argv[3]) if len(sys.argv) > 3 else reader.TimestepValues[-1]
reader.UpdatePipeline(time)


def part(name):
    block = ExtractBlock(Input=reader)
    block.Assembly = 'Hierarchy'
    block.Selectors = ['//' + name]
    block.UpdatePipeline(time)
    points = block.GetDataInformation().GetNumberOfPoints()
    if points == 0:
        sys.exit('clayPicture: nothing to draw of %s at time %g' % (name, time))
    return block


mesh, clay = part('internalMesh'), part('clay')
low_x, high_x, low_y, high_y, low_z, high_z = mesh.GetDataInformation().GetBounds()
size = max(high_x - low_x, high_y - low_y)
number = clay.GetDataInformation().GetNumberOfPoints()

view = CreateView('RenderView')
view.ViewSize = [1200, 900]
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
view.ViewTime = time

# Behind the platelets: the plane through the middle, seen from +z
plane = Slice(Input=mesh)
plane.SliceType.Origin = [0.5*(low_x + high_x), 0.5*(low_y + high_y), low_z + 0.01*(high_z - low_z)]
plane.SliceType.Normal = [0, 0, 1]
plane.UpdatePipeline(time)
shown = Show(plane, view)
ColorBy(shown, ('CELLS', 'alpha.clay'))
fraction = GetColorTransferFunction('alpha.clay')
fraction.ApplyPreset('X Ray', True)
shown.RescaleTransferFunctionToDataRange(False, True)
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(fraction, view)
bar.Title, bar.ComponentTitle = 'solid fraction alpha.clay [-]', ''
bar.WindowLocation = 'Upper Right Corner'

# Velocity of the water as arrows
speed = plane.CellData['U'].GetRange(-1)[1] if 'U' in plane.CellData.keys() else 0
if speed > 0:
    centres = CellCenters(Input=plane)
    arrows = Glyph(Input=centres, GlyphType='2D Glyph')
    arrows.GlyphType.GlyphType = 'Arrow'
    arrows.OrientationArray = ['POINTS', 'U']
    arrows.ScaleArray = ['POINTS', 'U']
    arrows.ScaleFactor = 0.08*size/speed
    arrows.GlyphMode = 'Every Nth Point'
    arrows.Stride = 5
    arrows.UpdatePipeline(time)
    shown = Show(arrows, view)
    shown.ColorArrayName = [None, '']
    shown.AmbientColor = shown.DiffuseColor = [0.1, 0.35, 0.75]
    shown.LineWidth = 1.5
    shown.Position = [0, 0, 0.02*(high_z - low_z)]     # in front of the plane

# Platelets, coloured by speed
spheres = Glyph(Input=clay, GlyphType='Sphere')
spheres.GlyphType.Radius = 0.5
spheres.GlyphMode = 'All Points'
spheres.ScaleArray = ['POINTS', 'No scale array']
spheres.ScaleFactor = 0.35*((high_x - low_x)*(high_y - low_y)*(high_z - low_z)/number)**(1/3)
spheres.UpdatePipeline(time)
shown = Show(spheres, view)
ColorBy(shown, ('POINTS', 'U', 'Magnitude'))
colour = GetColorTransferFunction('U')
colour.ApplyPreset('Viridis (matplotlib)', True)
shown.RescaleTransferFunctionToDataRange(False, True)
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colour, view)
bar.Title, bar.ComponentTitle = 'speed of platelets [m/s]', ''
bar.WindowLocation = 'Lower Right Corner'

for transfer in (fraction, colour):
    bar = GetScalarBar(transfer, view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = 14
    bar.ScalarBarLength = 0.3

label = Text()
label.Text = 'time %.4g s, %d platelets; arrows: water, longest %.2g m/s' % (time, number, speed)
shown = Show(label, view)
shown.Color = [0, 0, 0]
shown.FontSize = 16
shown.WindowLocation = 'Upper Left Corner'

axes = Show(mesh, view)
axes.Representation = 'Outline'
axes.AmbientColor = axes.DiffuseColor = [0.4, 0.4, 0.4]
axes.ColorArrayName = [None, '']
axes.DataAxesGrid.GridAxesVisibility = 1
axes.DataAxesGrid.XTitle, axes.DataAxesGrid.YTitle, axes.DataAxesGrid.ZTitle = 'x [m], vertical y [m]', '', ''
for title in ('X', 'Y', 'Z'):
    setattr(axes.DataAxesGrid, title + 'LabelColor', [0, 0, 0])
    setattr(axes.DataAxesGrid, title + 'TitleColor', [0, 0, 0])
axes.DataAxesGrid.ZAxisUseCustomLabels = 1

Render(view)
view.CameraParallelProjection = 1
view.ResetActiveCameraToNegativeZ()
ResetCamera(view)
view.CameraParallelScale = 0.62*size
view.CameraFocalPoint = [0.5*(low_x + high_x) + 0.2*size, 0.5*(low_y + high_y), 0.5*(low_z + high_z)]
view.CameraPosition = [view.CameraFocalPoint[0], view.CameraFocalPoint[1], high_z + 10*size]
Render(view)
SaveScreenshot(out, view, ImageResolution=[1200, 900])
print('clayPicture: %s (time %g s, %d platelets)' % (out, time, number))
