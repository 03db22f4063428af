#!/usr/bin/env pvpython
# bentoFoam, GPL-3.0-or-later
"""Picture of an erosionFoam case in the plane of the fracture (x, y): the solid
fraction with streamlines of the water over it.

usage: etc/plots/pvrun pvpython etc/plots/fracturePicture.py CASE OUT.png
           [--time T] [--box X0 X1 Y0 Y1] [--log LEAST] [--high MOST]
           [--lines N] [--under FIELD TITLE] [--mirror]

    --time   another time than the last [s]
    --box    what is drawn [m], instead of all of the mesh
    --log    a logarithmic scale from this value on
    --high   the end of the scale; without: the largest value
    --lines  number of streamlines (30); they start evenly along the side that
             the water comes from
    --under  another field instead of alpha.clay, with its title
    --mirror the mesh is one half, above a plane of symmetry
"""
import argparse
import math
import os
import sys

from paraview.simple import *

parser = argparse.ArgumentParser(description=__doc__,
                                 formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument('case')
parser.add_argument('out')
parser.add_argument('--time', type=float)
parser.add_argument('--box', type=float, nargs=4)
parser.add_argument('--log', type=float)
parser.add_argument('--high', type=float)
parser.add_argument('--lines', type=int, default=30)
parser.add_argument('--under', nargs=2, default=['alpha.clay', 'solid fraction alpha.clay [-]'])
parser.add_argument('--mirror', action='store_true')
asked = parser.parse_args()
name, title = asked.under

foam = os.path.join(os.path.abspath(asked.case), 'case.foam')
open(foam, 'a').close()

reader = OpenFOAMReader(FileName=foam)
reader.CaseType = 'Reconstructed Case'
reader.SkipZeroTime = 0
reader.UpdatePipelineInformation()
reader.MeshRegions = ['internalMesh']
times = list(reader.TimestepValues)
time = times[-1] if asked.time is None else asked.time
if not any(math.isclose(time, known, rel_tol=1e-6) for known in times):
    sys.exit('fracturePicture: no fields at time %g s, but at %s'
             % (time, ', '.join('%g' % known for known in times)))
reader.UpdatePipeline(time)

bounds = reader.GetDataInformation().GetBounds()
box = list(asked.box or bounds[:4])
if asked.mirror and not asked.box:
    box[2] -= box[3] - box[2]
size = max(box[1] - box[0], box[3] - box[2])
unit, scale = ('µm', 1e6) if size < 1e-3 else ('mm', 1e3) if size < 1 else ('m', 1)
x0, x1, y0, y1 = (scale*b for b in box)
width, height = x1 - x0, y1 - y0
size *= scale
middle = [0.5*(x0 + x1), 0.5*(y0 + y1), 0.5*scale*(bounds[4] + bounds[5])]

block = ExtractBlock(Input=reader)
block.Assembly = 'Hierarchy'
block.Selectors = ['//internalMesh']
mesh = Transform(Input=block)
mesh.Transform.Scale = [scale]*3
mesh.TransformAllInputVectors = 1        # velocities are scaled too
if asked.mirror:
    mesh = Reflect(Input=mesh)
    mesh.Plane = 'Y Min'
    mesh.FlipAllInputArrays = 0
whole = MergeBlocks(Input=mesh)
plane = Slice(Input=whole)
plane.SliceType.Origin, plane.SliceType.Normal = middle, [0, 0, 1]
plane.Triangulatetheslice = 0
drawn = plane
if asked.box:
    # Cells of the box, cut at its sides
    for axis, value, invert in ((0, x0, 0), (0, x1, 1), (1, y0, 0), (1, y1, 1)):
        drawn = Clip(Input=drawn, ClipType='Plane')
        drawn.ClipType.Origin = [value if axis == 0 else 0, value if axis == 1 else 0, 0]
        drawn.ClipType.Normal = [1 - axis, axis, 0]
        drawn.Invert = invert
drawn.UpdatePipeline(time)
low, high = drawn.CellData[name].GetRange()


def ticks(low, high, number=5):
    """Round values between the two, about so many."""
    step = (high - low)/max(2, round(number))
    decade = 10**math.floor(math.log10(step))
    step = decade*min((1, 2, 5, 10), key=lambda n: abs(n*decade - step))
    first = math.ceil(low/step - 1e-6)
    return [n*step for n in range(first, math.floor(high/step + 1e-6) + 1)]


view = CreateView('RenderView')
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
view.ViewTime = time

shown = Show(drawn, view)
shown.Representation = 'Surface'
shown.Ambient, shown.Diffuse, shown.Specular = 1, 0, 0
ColorBy(shown, ('CELLS', name))
colour = GetColorTransferFunction(name)
colour.ColorSpace = 'RGB'
high = asked.high or max(high, 1e-12)
# Water to gel
shades = [(0.93, 0.96, 1), (0.98, 0.90, 0.70), (0.90, 0.62, 0.25), (0.60, 0.32, 0.10), (0.25, 0.11, 0.03)]
if asked.log:
    low = asked.log
    high = max(10**math.ceil(math.log10(high) - 1e-9), 10*low)
    decades = math.log10(high/low)
    values = [low*10**(decades*k/4) for k in range(5)]
    labels = [low*10.0**k for k in range(round(decades) + 1)]
else:
    low = 0 if name == 'alpha.clay' else low
    values = [low + (high - low)*k/4 for k in range(5)]
    labels = ticks(low, high)
colour.RGBPoints = [n for v, rgb in zip(values, shades) for n in (v, *rgb)]
if asked.log:
    colour.UseLogScale = 1
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colour, view)
bar.Title, bar.ComponentTitle = title, ''
bar.Orientation, bar.WindowLocation = 'Vertical', 'Any Location'
bar.Position, bar.ScalarBarLength = [0.87, 0.2], 0.6
bar.ScalarBarThickness = 22
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.TitleFontSize, bar.LabelFontSize = 20, 18
bar.AddRangeLabels = 0
bar.AutomaticLabelFormat, bar.LabelFormat = 0, '%.0e' if asked.log else '%.3g'
bar.UseCustomLabels, bar.CustomLabels = 1, labels

# Streamlines of velocities at the points, from the side that the water enters
points = CellDatatoPointData(Input=plane)
points.UpdatePipeline(time)
speeds = [points.PointData['U'].GetRange(k) for k in range(2)]
fastest = max(abs(s) for pair in speeds for s in pair)
if fastest > 0 and asked.lines > 0:
    mean = [0.5*(pair[0] + pair[1]) for pair in speeds]
    inset = 1e-3*size
    if abs(mean[0]) >= abs(mean[1]):
        x = x0 + inset if mean[0] > 0 else x1 - inset
        ends = [x, y0 + 0.5*height/asked.lines], [x, y1 - 0.5*height/asked.lines]
    else:
        y = y0 + inset if mean[1] > 0 else y1 - inset
        ends = [x0 + 0.5*width/asked.lines, y], [x1 - 0.5*width/asked.lines, y]
    lines = StreamTracer(Input=points, SeedType='Line')
    lines.Vectors = ['POINTS', 'U']
    lines.SeedType.Point1, lines.SeedType.Point2 = [[*end, middle[2]] for end in ends]
    lines.SeedType.Resolution = asked.lines - 1
    lines.MaximumStreamlineLength = 4*size
    # In lengths of cells: lines end where the first step leaves the mesh
    lines.MaximumStepLength = 0.1
    lines.MaximumSteps = 100000
    lines.IntegrationDirection = 'BOTH'
    lines.TerminalSpeed = 3e-3*fastest
    lines.SurfaceStreamlines = 1
    cut = lines
    if asked.box:
        for axis, value, invert in ((0, x0, 0), (0, x1, 1), (1, y0, 0), (1, y1, 1)):
            cut = Clip(Input=cut, ClipType='Plane')
            cut.ClipType.Origin = [value if axis == 0 else 0, value if axis == 1 else 0, 0]
            cut.ClipType.Normal = [1 - axis, axis, 0]
            cut.Invert = invert
    shown = Show(cut, view)
    shown.ColorArrayName = [None, '']
    shown.AmbientColor = shown.DiffuseColor = [0.13, 0.35, 0.62]
    shown.Ambient, shown.Diffuse = 1, 0
    shown.LineWidth = 2
    shown.Position = [0, 0, size]

year = 365.25*86400
label = Text()
with open(os.path.join(asked.case, 'system', 'fvSchemes')) as schemes:
    steady = 'steadyState' in schemes.read()
label.Text = '%s; %s' % (
    'steady' if steady else 'time %.4g %s' % (
        (time/year, 'years') if time > year else
        (time/3600, 'h') if time > 3600 else (time, 's')),
    'streamlines, fastest water %.3g m/s' % (fastest/scale) if fastest > 0 else 'water at rest')
shown = Show(label, view)
shown.Color = [0, 0, 0]
shown.FontSize = 20
shown.WindowLocation = 'Any Location'
shown.Position = [0.1, 0.945]

outline = Show(Outline(Input=drawn), view)
outline.AmbientColor = outline.DiffuseColor = [0.4, 0.4, 0.4]
outline.ColorArrayName = [None, '']
axes = outline.DataAxesGrid
axes.GridAxesVisibility = 1
axes.AxesToLabel = 3                # x and y, on the sides of their minimum
axes.XTitle, axes.YTitle, axes.ZTitle = 'x [%s]' % unit, 'y [%s]' % unit, ''
axes.XAxisUseCustomLabels, axes.XAxisLabels = 1, ticks(x0, x1, 6*width/size)
axes.YAxisUseCustomLabels, axes.YAxisLabels = 1, ticks(y0, y1, 6*height/size)
axes.ZAxisUseCustomLabels = 1
for axis in 'XYZ':
    setattr(axes, axis + 'LabelColor', [0, 0, 0])
    setattr(axes, axis + 'TitleColor', [0, 0, 0])
    setattr(axes, axis + 'LabelFontSize', 18)
    setattr(axes, axis + 'TitleFontSize', 20)

# As high as the box needs
pixels = [1200, max(400, round(1200*0.72*height/width + 170))]
view.ViewSize = pixels
Render(view)
view.CameraParallelProjection = 1
view.ResetActiveCameraToNegativeZ()
ResetCamera(view)
perPixel = width/(0.72*pixels[0])
view.CameraParallelScale = 0.5*pixels[1]*perPixel
view.CameraFocalPoint = [x0 + (0.5 - 0.1)*pixels[0]*perPixel, middle[1] - 14*perPixel, middle[2]]
view.CameraPosition = view.CameraFocalPoint[:2] + [middle[2] + 10*size]
Render(view)
SaveScreenshot(asked.out, view, ImageResolution=pixels, CompressionLevel='9')
print('fracturePicture: %s (time %g s)' % (asked.out, time))
