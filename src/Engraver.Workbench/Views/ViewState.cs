using Engraver.Core.Geometry;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Views;

/// <summary>The state of the view. Immutable.</summary>
public sealed record ViewState
{
    /// <summary>The view of a session that has no canvas and no drawing: A4 in millimetres.</summary>
    public static ViewState Default { get; } = new();

    /// <summary>Middle of the view, drawing units (AutoCAD's VIEWCTR).</summary>
    public Point2D Centre { get; init; } = new(148.5, 105.0);

    /// <summary>Height of the view, drawing units, above 0 (VIEWSIZE).</summary>
    public double Height { get; init; } = 210.0;

    /// <summary>Width over height of the canvas, above 0.</summary>
    public double Aspect { get; init; } = 297.0 / 210.0;

    /// <summary>Height of the canvas in the units of its control, which are pixels on an unscaled screen; null without a canvas.</summary>
    public double? CanvasHeight { get; init; }

    public bool Grid { get; init; } = true;

    public bool Snap { get; init; }

    public bool Ortho { get; init; }

    public bool ObjectSnap { get; init; } = true;

    /// <summary>The active object snaps, as in AutoCAD's OSMODE: 1 end, 2 middle, 4 centre, 8 node, 16 quadrant, 32 intersection, 128 perpendicular, 256
    /// tangent, 512 nearest.</summary>
    public int ObjectSnapModes { get; init; } = 1 + 2 + 4 + 16 + 32;

    /// <summary>One-time object snap for the next point, in the format of <see cref="ObjectSnapModes"/> (0: none); null: the active ones.</summary>
    public int? OneTimeSnap { get; init; }

    /// <summary>The cursor snaps to multiples of <see cref="PolarAngle"/> from the previous point (POLAR); excludes <see cref="Ortho"/>.</summary>
    public bool Polar { get; init; }

    /// <summary>Step of polar tracking, degrees, above 0 (POLARANG).</summary>
    public double PolarAngle { get; init; } = 90.0;

    public bool DynamicInput { get; init; } = true;

    /// <summary>Distance of grid lines, drawing units; the canvas draws every tenth, hundredth, ... line if they are too close.</summary>
    public double GridSpacing { get; init; } = 10.0;

    /// <summary>Spacing of the snap grid, drawing units.</summary>
    public double SnapSpacing { get; init; } = 10.0;

    public CanvasLayers Shown { get; init; } =
        CanvasLayers.Drawing | CanvasLayers.Rapids | CanvasLayers.StartPoints | CanvasLayers.Findings | CanvasLayers.Machine | CanvasLayers.WorkOrigin | CanvasLayers.Engraved | CanvasLayers.Trajectories | CanvasLayers.Operations;

    public DesktopTheme Theme { get; init; }

    /// <summary>The marked point; null for none.</summary>
    public ViewFocus? Focus { get; init; }

    public double Width => Height * Aspect;

    /// <summary>The visible part of the drawing.</summary>
    public Bounds2D Window => new(Centre.X - (Width / 2.0), Centre.Y - (Height / 2.0), Centre.X + (Width / 2.0), Centre.Y + (Height / 2.0));
}
