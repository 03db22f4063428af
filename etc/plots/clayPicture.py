#!/usr/bin/env pvpython
# bentoFoam, GPL-3.0-or-later
"""Picture of a clayFoam case, seen from +z: platelets coloured by speed, over
the solid fraction and the velocity of the water in the middle plane.

usage: etc/plots/pvrun pvpython etc/plots/clayPicture.py CASE OUT.png [TIME]
"""
import math
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
times = list(reader.TimestepValues)
time = float(sys.argv[3]) if len(sys.argv) > 3 else times[-1]
if not any(math.isclose(time, known, rel_tol=1e-6) for known in times):
    sys.exit('clayPicture: no fields at time %g s, but at %s'
             % (time, ', '.join('%g' % known for known in times)))
reader.UpdatePipeline(time)

bounds = reader.GetDataInformation().GetBounds()
size = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
unit, scale = ('µm', 1e6) if size < 1e-3 else ('mm', 1e3)
mm_per_s = 'mag(U)*%g' % (1e3/scale)


def in_water(cloud):
    """Without those in the layers of inlets, which are outside the mesh."""
    cloud.UpdatePipeline(time)
    if cloud.PointData['inlet'] is None:
        return cloud
    water = Threshold(Input=cloud, Scalars=['POINTS', 'inlet'])
    water.ThresholdMethod, water.LowerThreshold = 'Below Lower Threshold', -0.5
    return water


def part(name):
    """The mesh or the cloud, with lengths in the unit of the axes."""
    block = ExtractBlock(Input=reader)
    block.Assembly = 'Hierarchy'
    block.Selectors = ['//' + name]
    scaled = Transform(Input=in_water(block) if name == 'clay' else block)
    scaled.Transform.Scale = [scale, scale, scale]
    scaled.TransformAllInputVectors = 1     # velocities are scaled too
    scaled.UpdatePipeline(time)
    if scaled.GetDataInformation().GetNumberOfPoints() == 0:
        sys.exit('clayPicture: nothing to draw of %s at time %g' % (name, time))
    return scaled


def ticks(low, high, number=5):
    """Round values between the two, about so many."""
    step = (high - low)/max(2, round(number))
    decade = 10**math.floor(math.log10(step))
    step = decade*min((1, 2, 5, 10), key=lambda n: abs(n*decade - step))
    first = math.ceil(low/step - 1e-6)
    return [n*step for n in range(first, math.floor(high/step + 1e-6) + 1)]


def colour_bar(transfer, title, values, place):
    bar = GetScalarBar(transfer, view)
    bar.Title, bar.ComponentTitle = title, ''
    bar.Orientation, bar.WindowLocation = 'Vertical', 'Any Location'
    bar.Position, bar.ScalarBarLength = place, 0.34
    bar.ScalarBarThickness = 22
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize, bar.LabelFontSize = 20, 18
    bar.AddRangeLabels = 0
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, '%.4g'
    bar.UseCustomLabels, bar.CustomLabels = 1, values


mesh, clay = part('internalMesh'), part('clay')
low_x, high_x, low_y, high_y, low_z, high_z = mesh.GetDataInformation().GetBounds()
width, height, depth = high_x - low_x, high_y - low_y, high_z - low_z
middle = [0.5*(low_x + high_x), 0.5*(low_y + high_y), 0.5*(low_z + high_z)]
size *= scale
# The picture [pixels]: the box, margins for the axes, the label and the bars
pixel = size/760
left, right, bottom, top = 110, 270, 80, 60
pixels = [max(760, round(width/pixel) + left + right), round(height/pixel) + bottom + top]
number = clay.GetDataInformation().GetNumberOfPoints()

view = CreateView('RenderView')
view.ViewSize = pixels
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
view.ViewTime = time

# The solid fraction of the middle plane, behind the platelets; light, so that
# these stand out
plane = Slice(Input=mesh)
plane.SliceType.Origin, plane.SliceType.Normal = middle, [0, 0, 1]
plane.Triangulatetheslice = 0
plane.UpdatePipeline(time)
shown = Show(plane, view)
shown.Position = [0, 0, -depth]
shown.Ambient, shown.Diffuse = 1, 0
ColorBy(shown, ('CELLS', 'alpha.clay'))
most = max(plane.CellData['alpha.clay'].GetRange()[1], 1e-6)
fraction = GetColorTransferFunction('alpha.clay')
fraction.RGBPoints = [0, 1, 1, 1, 0.5*most, 0.87, 0.80, 0.70, most, 0.72, 0.60, 0.45]
shown.SetScalarBarVisibility(view, True)
colour_bar(fraction, 'solid fraction alpha.clay [-]', ticks(0, most), [1 - 190/pixels[0], 0.54])

# Platelets as balls, coloured by speed, three decades of it
speeds = Calculator(Input=clay)
speeds.ResultArrayName, speeds.Function = 'speed', 'max(%s, 1e-30)' % mm_per_s
speeds.UpdatePipeline(time)
fastest = speeds.PointData['speed'].GetRange()[1]
decade = math.ceil(math.log10(fastest)) if fastest > 1e-20 else 0
balls = Glyph(Input=speeds, GlyphType='Sphere')
balls.GlyphType.Radius = 0.5
balls.GlyphMode = 'All Points'
balls.ScaleArray = ['POINTS', 'No scale array']
balls.ScaleFactor = 0.3*(width*height*depth/number)**(1/3)
balls.UpdatePipeline(time)
shown = Show(balls, view)
shown.Ambient, shown.Diffuse, shown.Specular = 0.35, 0.75, 0
ColorBy(shown, ('POINTS', 'speed'))
colour = GetColorTransferFunction('speed')
colour.ApplyPreset('Viridis (matplotlib)', True)
colour.RescaleTransferFunction(10**(decade - 3), 10**decade)
colour.MapControlPointsToLogSpace()
colour.UseLogScale = 1
shown.SetScalarBarVisibility(view, True)
colour_bar(colour, 'speed of the platelets [mm/s]',
           [10.0**n for n in range(decade - 3, decade + 1)],
           [1 - 190/pixels[0], 0.09])

# Velocity of the water as arrows, in front of all, where it is 3 % of the
# fastest or more
columns = max(1, round(10*width/size))
rows = max(1, round(16*height/size))
grid = ResampleToImage(Input=mesh)
grid.UseInputBounds = 0
grid.SamplingDimensions = [columns, rows, 1]
grid.SamplingBounds = [low_x + 0.5*width/columns, high_x - 0.5*width/columns,
                       low_y + 0.5*height/rows, high_y - 0.5*height/rows, middle[2], middle[2]]
water = Calculator(Input=grid)
water.ResultArrayName, water.Function = 'water', mm_per_s
water.UpdatePipeline(time)
speed = water.PointData['water'].GetRange()[1]
if speed > 0:
    flowing = Threshold(Input=water, Scalars=['POINTS', 'water'])
    flowing.LowerThreshold, flowing.UpperThreshold = 0.03*speed, speed
    arrows = Glyph(Input=flowing, GlyphType='Arrow')
    arrows.GlyphType.TipResolution = arrows.GlyphType.ShaftResolution = 16
    arrows.GlyphType.TipRadius, arrows.GlyphType.ShaftRadius = 0.12, 0.035
    arrows.GlyphType.TipLength = 0.3
    arrows.OrientationArray = arrows.ScaleArray = ['POINTS', 'U']
    arrows.VectorScaleMode = 'Scale by Magnitude'
    arrows.ScaleFactor = 0.85*width/columns/(speed*scale/1e3)
    arrows.GlyphMode = 'All Points'
    arrows.UpdatePipeline(time)
    shown = Show(arrows, view)
    shown.ColorArrayName = [None, '']
    shown.AmbientColor = shown.DiffuseColor = [0.80, 0.10, 0.10]
    shown.Ambient, shown.Diffuse = 1, 0
    shown.Position = [-0.425*width/columns, 0, 2*depth]

label = Text()
label.Text = 'time %.4g %s, %d platelets; %s' % (
    *((1e3*time, 'ms') if time < 1 else (time, 's')), number,
    'arrows: water, longest %.3g mm/s' % speed if speed > 0 else 'water at rest')
shown = Show(label, view)
shown.Color = [0, 0, 0]
shown.FontSize = 20
shown.WindowLocation = 'Upper Left Corner'

outline = Show(mesh, view)
outline.Representation = 'Outline'
outline.AmbientColor = outline.DiffuseColor = [0.4, 0.4, 0.4]
outline.ColorArrayName = [None, '']
axes = outline.DataAxesGrid
axes.GridAxesVisibility = 1
axes.AxesToLabel = 3                # x and y, on the sides of their minimum
axes.XTitle, axes.YTitle, axes.ZTitle = 'x [%s]' % unit, 'y [%s]' % unit, ''
axes.XAxisUseCustomLabels, axes.XAxisLabels = 1, ticks(low_x, high_x, 5*width/size)
axes.YAxisUseCustomLabels, axes.YAxisLabels = 1, ticks(low_y, high_y, 5*height/size)
axes.ZAxisUseCustomLabels = 1
for axis in 'XYZ':
    setattr(axes, axis + 'LabelColor', [0, 0, 0])
    setattr(axes, axis + 'TitleColor', [0, 0, 0])
    setattr(axes, axis + 'LabelFontSize', 18)
    setattr(axes, axis + 'TitleFontSize', 20)

Render(view)
view.CameraParallelProjection = 1
view.ResetActiveCameraToNegativeZ()
ResetCamera(view)
view.CameraParallelScale = 0.5*pixels[1]*pixel
view.CameraFocalPoint = [low_x + (0.5*pixels[0] - left)*pixel,
                         low_y + (0.5*pixels[1] - bottom)*pixel, middle[2]]
view.CameraPosition = view.CameraFocalPoint[:2] + [high_z + 10*size]
Render(view)
SaveScreenshot(out, view, ImageResolution=pixels, CompressionLevel='9')
print('clayPicture: %s (time %g s, %d platelets)' % (out, time, number))
