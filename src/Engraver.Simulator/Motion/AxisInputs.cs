namespace Engraver.Simulator.Motion;

/// <summary>Limit switches, home switch and index of one axis (galil-dmc.md C.1, C.2). A switch is operated by hand, by the position of the axis, or
/// both.</summary>
internal sealed class AxisInputs(InputPolarity polarity, AxisSwitches? switches)
{
    private const int UsualPeriod = 4000;
    private double _place;

    /// <summary>The axis has switches or an index that its motion operates.</summary>
    public bool HasSwitches => switches is not null;

    /// <summary>The forward limit input was grounded by hand.</summary>
    public bool ForwardGrounded { get; set; }

    public bool ReverseGrounded { get; set; }

    public bool HomeGrounded { get; set; }

    /// <summary>Grounds or opens a limit input by hand.</summary>
    public void Ground(bool forward, bool active)
    {
        if (forward) ForwardGrounded = active;
        else ReverseGrounded = active;
    }

    /// <summary>The limit blocks motion: <c>_LF</c> is 0.</summary>
    public bool ForwardHit => IsGrounded(ForwardGrounded, switches?.ForwardLimitAt is { } at && _place >= at, switches?.ForwardLimitAt) != polarity.LimitsActiveHigh;

    public bool ReverseHit => IsGrounded(ReverseGrounded, switches?.ReverseLimitAt is { } at && _place <= at, switches?.ReverseLimitAt) != polarity.LimitsActiveHigh;

    /// <summary>The value of <c>_HM</c> (C.2, table).</summary>
    public bool Home => (HomeGrounded || (switches?.HomeAt is not null && IsOnHome != (switches.AreNormallyClosed || switches.IsHomeNormallyClosed))) == polarity.HomeReversed;

    private bool IsOnHome => switches is { HomeAt: { } at } && (switches.IsHomeBelow ? at - _place : _place - at) is >= 0 and var depth && depth <= switches.HomeReach;

    /// <summary>Distance from the present position to the index pulse passed in the last sample; null when no pulse was passed.</summary>
    public double? IndexPassed { get; private set; }

    /// <summary>Takes the present motor position, in counts from its position at power up.</summary>
    public void MoveTo(double place)
    {
        IndexPassed = null;
        if (place == _place) return;
        double at = switches?.IndexAt ?? 0;
        double period = switches?.IndexPeriod ?? UsualPeriod;
        var upper = Math.Max(place, _place);
        var pulse = at + (Math.Floor((upper - at) / period) * period);
        IndexPassed = pulse > Math.Min(place, _place) ? pulse - place : null;
        _place = place;
    }

    private bool IsGrounded(bool byHand, bool pressed, int? fitted) =>
        byHand || (fitted is not null && pressed != (switches?.AreNormallyClosed ?? false));
}
