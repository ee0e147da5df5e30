namespace Engraver.App.Canvas.Rasterising;

/// <summary>How lines are drawn, in pixels of the screen.</summary>
/// <param name="Width">Above 0.</param>
/// <param name="Dash">Length of a dash; 0 for a solid line.</param>
/// <param name="Gap">Length between dashes.</param>
internal readonly record struct LinePen(double Width, double Dash = 0.0, double Gap = 0.0)
{
    public static LinePen Hairline => new(1.0);

    public bool IsDashed => Dash > 0.0;

    /// <summary>Maximum distance from the middle of a line at which (the centres of) pixels are touched: half the width and half a pixel.</summary>
    public double Reach => (Width / 2.0) + 0.5;

    /// <summary>Is the line drawn at this distance from its start?</summary>
    public bool IsOn(double along) => !IsDashed || along - (Math.Floor(along / (Dash + Gap)) * (Dash + Gap)) < Dash;
}
