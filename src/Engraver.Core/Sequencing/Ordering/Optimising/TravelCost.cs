namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>What the optimal order minimises: the distance between the strokes, or the time of the rapids. Switching the tool takes the same time for each
/// stroke, whatever their order.</summary>
/// <param name="X">The X axis of the drawing; null for the distance.</param>
/// <param name="Y">The Y axis of the drawing; null for the distance.</param>
public sealed record TravelCost(AxisRapid? X, AxisRapid? Y)
{
    /// <summary>The sum of the distances, millimetres.</summary>
    public static TravelCost Distance { get; } = new(null, null);

    /// <summary>The sum of the times, seconds: both axes move at once, and a rapid ends with the slower one.</summary>
    public static TravelCost Time(AxisRapid x, AxisRapid y) => new(x, y);
}
