namespace Engraver.Workbench.Certificates;

/// <summary>The bounds of the cut, and the travel of the machine.</summary>
/// <param name="TravelX">Length of the travel; null when the profile does not define it.</param>
/// <param name="Fits">False if the bounds exceed the travel. The position is known only when the work is placed.</param>
public sealed record CertifiedLimits(double MinX, double MinY, double MaxX, double MaxY, double? TravelX, double? TravelY, bool Fits)
{
    /// <summary>Height of the deepest cut, mm above the surface of the work; null if no axis moves the tool or the target has no heights.</summary>
    public double? MinZ { get; init; }

    /// <summary>Largest height of the tool, like <see cref="MinZ"/>.</summary>
    public double? MaxZ { get; init; }

    /// <summary>Length of the travel in height; null when the profile does not define it.</summary>
    public double? TravelZ { get; init; }
}
