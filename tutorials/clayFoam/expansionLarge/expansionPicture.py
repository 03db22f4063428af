#!/usr/bin/env pvpython
# bentoFoam, GPL-3.0-or-later
"""Pictures of a box that fills with clay from below: all platelets at the last of
the given times (FOLDER/box.png), and a cut through the box at each of them
(FOLDER/cuts.png).

usage: etc/plots/pvrun pvpython expansionPicture.py CASE FOLDER TIME...
"""
import os
import sys

from paraview.simple import *

case, folder = os.path.abspath(sys.argv[1]), sys.argv[2]
times = [float(time) for time in sys.argv[3:]]

spacing = 0.3           # [um]

foam = os.path.join(case, 'case.foam')
open(foam, 'a').close()
reader = OpenFOAMReader(FileName=foam)
reader.CaseType = 'Reconstructed Case'
reader.SkipZeroTime = 0
reader.UpdatePipelineInformation()
reader.MeshRegions = ['internalMesh', 'lagrangian/clay']
known = list(reader.TimestepValues)
for time in times:
    if not any(abs(time - other) < 1e-6*time for other in known):
        sys.exit('expansionPicture: no fields at %g s, but at %s s'
                 % (time, ', '.join('%g' % other for other in known)))


def part(name, time):
    """The mesh or the cloud as it is at a time, in um, whatever time a view has."""
    block = ExtractBlock(Input=reader)
    block.Assembly = 'Hierarchy'
    block.Selectors = ['//' + name]
    scaled = Transform(Input=block)
    scaled.Transform.Scale = [1e6, 1e6, 1e6]
    scaled.TransformAllInputVectors = 0
    merged = MergeBlocks(Input=scaled)
    merged.UpdatePipeline(time)
    if merged.GetDataInformation().GetNumberOfPoints() == 0:
        sys.exit('expansionPicture: nothing to draw of %s at %g s' % (name, time))
    then = servermanager.Fetch(merged)
    kept = TrivialProducer()
    kept.GetClientSideObject().SetOutput(then)
    kept.UpdatePipeline()
    return kept


def between(source, name, low, high):
    chosen = Threshold(Input=source, Scalars=['POINTS', name])
    chosen.LowerThreshold, chosen.UpperThreshold = low, high
    chosen.UpdatePipeline()
    return chosen


def in_water(time):
    """The platelets, without those that wait behind the inlet."""
    return between(part('clay', time), 'inlet', -1, -1)


def count(source):
    return source.GetDataInformation().GetNumberOfPoints()


def new_view(width, height):
    view = CreateView('RenderView')
    view.ViewSize = [width, height]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    return view


def text(view, words, place):
    label = Text()
    label.Text = words
    shown = Show(label, view)
    shown.Color = [0, 0, 0]
    shown.FontSize = 20
    shown.Justification = 'Left'
    shown.WindowLocation = 'Any Location'
    shown.Position = place


def colour_bar(view, transfer, title, place, values):
    bar = GetScalarBar(transfer, view)
    bar.Visibility = 1
    bar.Title, bar.ComponentTitle = title, ''
    bar.Orientation, bar.WindowLocation = 'Horizontal', 'Any Location'
    bar.Position, bar.ScalarBarLength = place, 0.26
    bar.ScalarBarThickness = 16
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize, bar.LabelFontSize = 18, 17
    bar.AddRangeLabels = 0
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, '%.4g'
    bar.UseCustomLabels, bar.CustomLabels = 1, values


def outline(source, view, lift=0):
    shown = Show(Outline(Input=source), view)
    shown.AmbientColor = shown.DiffuseColor = [0.3, 0.3, 0.3]
    shown.ColorArrayName = [None, '']
    shown.Position = [0, lift, 0]


# All platelets, coloured by height
mesh = part('internalMesh', times[-1])
low_x, high_x, low_y, high_y, low_z, high_z = mesh.GetDataInformation().GetBounds()
middle = [0.5*(low_x + high_x), 0.5*(low_y + high_y), 0.5*(low_z + high_z)]
size = high_x - low_x

box = new_view(1400, 640)
heights = Calculator(Input=in_water(times[-1]))
heights.ResultArrayName, heights.Function = 'height', 'coordsY'
heights.UpdatePipeline()
shown = Show(heights, box)
shown.Representation = 'Points'
shown.PointSize = 2
ColorBy(shown, ('POINTS', 'height'))
colour = GetColorTransferFunction('height')
colour.ApplyPreset('Viridis (matplotlib)', True)
colour.RescaleTransferFunction(0, high_y)
colour_bar(box, colour, 'height above the inlet [µm]', [0.71, 0.87],
           list(range(int(high_y + 1.01))))
outline(mesh, box)
text(box, '%d platelets at %.3g ms\nin a box of %.3g x %.3g x %.3g µm'
     % (count(heights), 1e3*times[-1], high_x, high_y, high_z), [0.02, 0.87])
Render(box)
box.CameraFocalPoint = [middle[0] + 0.02*size, -0.03*size, middle[2]]
box.CameraPosition = [middle[0] + 0.95*size, 1.0*size, middle[2] + 2.0*size]
box.CameraViewUp = [0, 1, 0]
box.CameraViewAngle = 16.5
Render(box)
SaveScreenshot(os.path.join(folder, 'box.png'), box, ImageResolution=[1400, 640],
               CompressionLevel='9')

# Cuts, one above the other, of a part of the width
width = min(20, high_x)
pitch = high_y + 0.2*width*0.25
pixels = 1340/width
tall = round(pixels*pitch*len(times)) + 90
cuts = new_view(1400, tall)
fraction = GetColorTransferFunction('alpha.clay')
for k, time in enumerate(times):
    lift = (len(times) - 1 - k)*pitch
    piece = Clip(Input=part('internalMesh', time), ClipType='Box')
    piece.ClipType.Position = [0, -1, middle[2] - 0.01]
    piece.ClipType.Length = [width, high_y + 2, 0.02]
    piece.Crinkleclip = 0
    piece.UpdatePipeline()
    shown = Show(piece, cuts)
    shown.Representation = 'Surface'
    shown.Position = [0, lift, -2]
    shown.Ambient, shown.Diffuse = 1, 0
    ColorBy(shown, ('CELLS', 'alpha.clay'))
    outline(piece, cuts, lift)

    clay = in_water(time)
    place = Calculator(Input=clay)
    place.ResultArrayName, place.Function = 'fromCut', 'abs(coordsZ - %g)' % middle[2]
    near = between(place, 'fromCut', 0, 0.5*spacing)
    along = Calculator(Input=near)
    along.ResultArrayName, along.Function = 'along', 'coordsX'
    balls = Glyph(Input=between(along, 'along', 0, width), GlyphType='Sphere')
    balls.GlyphType.Radius = 0.5
    balls.GlyphMode = 'All Points'
    balls.ScaleArray = ['POINTS', 'No scale array']
    balls.OrientationArray = ['POINTS', 'No orientation array']
    balls.ScaleFactor = 0.35*spacing
    balls.UpdatePipeline()
    shown = Show(balls, cuts)
    shown.ColorArrayName = [None, '']
    shown.AmbientColor = shown.DiffuseColor = [0.10, 0.25, 0.45]
    shown.Ambient, shown.Diffuse, shown.Specular = 0.5, 0.6, 0
    shown.Position = [0, lift, 0]
    text(cuts, '%.3g ms: %d platelets in the box' % (1e3*time, count(clay)),
         [30/1400, (20 + pixels*(lift + high_y + 0.02*width*0.5))/tall])
# Showing has fitted the colours to the last one
fraction.RGBPoints = [0, 1, 1, 1, 7e-4, 0.93, 0.87, 0.77, 1.4e-3, 0.80, 0.66, 0.46]
colour_bar(cuts, fraction, 'solid fraction alpha.clay [-]', [0.71, 1 - 75/tall],
           [0, 4e-4, 8e-4, 1.2e-3])
Render(cuts)
cuts.InteractionMode = '2D'
cuts.CameraParallelProjection = 1
cuts.CameraParallelScale = 0.5*tall/pixels
centre = [0.5*width, (0.5*tall - 20)/pixels, middle[2]]
cuts.CameraFocalPoint = centre
cuts.CameraPosition = centre[:2] + [middle[2] + 100]
cuts.CameraViewUp = [0, 1, 0]
Render(cuts)
SaveScreenshot(os.path.join(folder, 'cuts.png'), cuts, ImageResolution=[1400, tall],
               CompressionLevel='9')
print('expansionPicture: %s/box.png, cuts.png (%d platelets at %g s)'
      % (folder, count(heights), times[-1]))
