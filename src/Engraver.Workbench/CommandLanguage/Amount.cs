using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>The answer to the prompt.</summary>
public abstract record Amount
{
    private Amount()
    {
    }

    /// <summary>In the unit of the prompt: degrees, a length in drawing units, a factor.</summary>
    public sealed record Number(double Value) : Amount;

    /// <summary>The first point of the measured vector, drawing units.</summary>
    public sealed record FirstPoint(Point2D Point) : Amount;
}
