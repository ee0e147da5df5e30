namespace Engraver.Simulator.Motion;

/// <summary>The motor with its encoder: perfect, or a first-order lag behind the command (galil-dmc.md I.14).</summary>
internal sealed class Motor(TimeSpan lag)
{
    private const double AlmostThere = 0.01;
    private readonly double _share = lag <= TimeSpan.Zero ? 1 : 1 - Math.Exp(-Ramp.Sample / lag.TotalSeconds);

    /// <summary>Encoder position, counts.</summary>
    public double Position { get; private set; }

    /// <summary>The shaft is blocked: the motor does not move and the position error grows.</summary>
    public bool IsHeld { get; set; }

    /// <summary>Always at its commanded position: no lag, not blocked.</summary>
    public bool IsPlain => _share >= 1 && !IsHeld;

    public int Counts => (int)Math.Round(Position, MidpointRounding.AwayFromZero);

    /// <summary>Moves for one sample towards the commanded position; a motor that is off stays where it is.</summary>
    public void Follow(double commanded, bool isOff)
    {
        if (IsHeld || isOff) return;
        Position += (commanded - Position) * _share;
        if (Math.Abs(commanded - Position) < AlmostThere) Position = commanded;
    }

    /// <summary>It will still move although the commanded position does not change.</summary>
    public bool IsSettling(double commanded, bool isOff) => _share < 1 && !IsHeld && !isOff && Position != commanded;

    public void Define(double position) => Position = position;
}
