using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for a corner of a window or a scale factor: <c>x,y</c>, <c>2</c> or <c>2X</c>.</summary>
public sealed record ZoomPrompt(string Instruction) : ValuePrompt<ZoomRequest>(Instruction)
{
    public override PointAim Aim => PointAim.FirstCorner;

    public override Reading<ZoomRequest> Read(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var relative = typed[^1] is 'x' or 'X';
        if (NumberPrompt.TryNumber(relative ? typed[..^1] : typed, out var factor))
            return factor > 0.0 ? new Reading<ZoomRequest>.Value(new ZoomRequest.Scale(factor, relative)) : new Reading<ZoomRequest>.Wrong(Wording.Get("ZoomPrompt.ScaleFactorNotPositive"));
        return new PointPrompt(Instruction).Read(typed, lastPoint) switch
        {
            Reading<Point2D>.Value point => new Reading<ZoomRequest>.Value(new ZoomRequest.Corner(point.Of)),
            _ => new Reading<ZoomRequest>.Wrong(Wording.Get("ZoomPrompt.InvalidInput", typed)),
        };
    }
}

/// <summary>The input at ZOOM besides its options.</summary>
public abstract record ZoomRequest
{
    private ZoomRequest()
    {
    }

    /// <summary>The first corner of a window.</summary>
    public sealed record Corner(Point2D Point) : ZoomRequest;

    /// <param name="Factor">Above 0; larger is nearer.</param>
    /// <param name="Relative">True for <c>2X</c>: relative to the current view. False: relative to the extents.</param>
    public sealed record Scale(double Factor, bool Relative) : ZoomRequest;
}
