using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>How much, as it was answered.</summary>
public abstract record Amount
{
    private Amount()
    {
    }

    /// <summary>In the unit of the prompt: degrees, a length in drawing units, a factor.</summary>
    public sealed record Number(double Of) : Amount;

    /// <summary>The place where the way begins that shows it, drawing units.</summary>
    public sealed record Beginning(Point2D At) : Amount;
}
