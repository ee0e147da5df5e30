using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>A span as plain polynomials, for fast repeated evaluation. For high degrees it is less exact than the span, which is then used instead.</summary>
internal sealed class PowerBasis
{
    private const int HighestDegree = 7;

    private readonly BezierSpan _span;
    private readonly double[] _x = [];
    private readonly double[] _y = [];
    private readonly double[] _w = [];
    private readonly Point2D _origin;

    public PowerBasis(BezierSpan span)
    {
        _span = span;
        if (span.Degree > HighestDegree) return;
        _origin = span.Start;
        double[] Column(Func<int, double> of) => Powers([.. Enumerable.Range(0, span.Degree + 1).Select(of)]);
        _x = Column(i => (span.Control(i).X - _origin.X) * span.Weight(i));
        _y = Column(i => (span.Control(i).Y - _origin.Y) * span.Weight(i));
        _w = Column(span.Weight);
    }

    public Point2D Evaluate(double parameter, out Vector2D slope)
    {
        if (_x.Length == 0) return _span.Evaluate(parameter, out slope);
        double x = 0.0, y = 0.0, w = 0.0, dx = 0.0, dy = 0.0, dw = 0.0;
        for (var i = _x.Length - 1; i >= 0; i--)
        {
            (dx, dy, dw) = ((dx * parameter) + x, (dy * parameter) + y, (dw * parameter) + w);
            (x, y, w) = ((x * parameter) + _x[i], (y * parameter) + _y[i], (w * parameter) + _w[i]);
        }

        (x, y) = (x / w, y / w);
        slope = new Vector2D((dx - (x * dw)) / w, (dy - (y * dw)) / w);
        return new Point2D(_origin.X + x, _origin.Y + y);
    }

    /// <summary>Length of the derivative.</summary>
    public double Speed(double parameter)
    {
        Evaluate(parameter, out var slope);
        return slope.Length;
    }

    /// <summary>Coefficients of the powers: differences of the Bernstein coefficients times binomials.</summary>
    private static double[] Powers(double[] bernstein)
    {
        var (degree, powers) = (bernstein.Length - 1, new double[bernstein.Length]);
        for (var k = 0; k <= degree; k++)
        {
            powers[k] = bernstein[0] * Bernstein.Binomials[degree][k];
            for (var i = 0; i < degree - k; i++) bernstein[i] = bernstein[i + 1] - bernstein[i];
        }

        return powers;
    }
}
