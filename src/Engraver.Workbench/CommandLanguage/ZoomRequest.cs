using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>The input at ZOOM besides its options.</summary>
public abstract record ZoomRequest
{
    private ZoomRequest()
    {
    }

    /// <summary>The first corner of a window.</summary>
    public sealed record WindowCorner(Point2D Point) : ZoomRequest;

    /// <param name="Factor">Above 0; larger is nearer.</param>
    /// <param name="Relative">True for <c>2X</c>: relative to the current view. False: relative to the extents.</param>
    public sealed record Scale(double Factor, bool Relative) : ZoomRequest;
}
