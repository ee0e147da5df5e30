namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Cost of one move between strokes. Implemented by structures, so that the compiler inlines it into the search.</summary>
internal interface ITravelMeasure
{
    /// <param name="dx">Distance in X, millimetres, with sign.</param>
    /// <param name="dy">Distance in Y.</param>
    double Of(double dx, double dy);
}

/// <summary>Millimetres.</summary>
internal readonly struct DistanceMeasure : ITravelMeasure
{
    public double Of(double dx, double dy) => Math.Sqrt((dx * dx) + (dy * dy));
}

/// <summary>Seconds of a rapid.</summary>
internal readonly struct RapidMeasure(AxisRapid x, AxisRapid y) : ITravelMeasure
{
    public double Of(double dx, double dy) => Math.Max(x.Seconds(Math.Abs(dx)), y.Seconds(Math.Abs(dy)));
}

/// <summary>The cost of another measure; 0 to a place that is not a number: the free end of an order after which the tool does not return.</summary>
internal readonly struct OpenEndMeasure<T>(T inner) : ITravelMeasure
    where T : struct, ITravelMeasure
{
    public double Of(double dx, double dy) => double.IsNaN(dx) ? 0.0 : inner.Of(dx, dy);
}
