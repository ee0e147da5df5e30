using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>What may be typed at ZOOM besides its options.</summary>
public abstract record ZoomWish
{
    private ZoomWish()
    {
    }

    /// <summary>The first corner of a window.</summary>
    public sealed record Corner(Point2D Point) : ZoomWish;

    /// <param name="Factor">Above 0; larger is nearer.</param>
    /// <param name="Relative">True for <c>2X</c>: relative to what is seen. False: relative to the whole drawing.</param>
    public sealed record Scale(double Factor, bool Relative) : ZoomWish;
}
