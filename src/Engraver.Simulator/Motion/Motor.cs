namespace Engraver.Simulator.Motion;

/// <summary>The motor with its encoder: perfect, or a first-order lag behind the command (galil-dmc.md I.14).</summary>
internal sealed class Motor(TimeSpan lag)
{
    private const double AlmostThere = 0.01;
    private readonly double _share = lag <= TimeSpan.Zero ? 1 : 1 - Math.Exp(-Ramp.Sample / lag.TotalSeconds);

    /// <summary>What the encoder counts.</summary>
    public double Position { get; private set; }

    /// <summary>Something holds the shaft: the position error grows.</summary>
    public bool IsHeld { get; set; }

    /// <summary>It stands where its command is, always.</summary>
    public bool IsPlain => _share >= 1 && !IsHeld;

    public int Counts => (int)Math.Round(Position, MidpointRounding.AwayFromZero);

    /// <summary>One sample towards the command; a motor that is off stays where it is.</summary>
    public void Follow(double commanded, bool isOff)
    {
        if (IsHeld || isOff) return;
        Position += (commanded - Position) * _share;
        if (Math.Abs(commanded - Position) < AlmostThere) Position = commanded;
    }

    /// <summary>It will still move although its command stands.</summary>
    public bool IsSettling(double commanded, bool isOff) => _share < 1 && !IsHeld && !isOff && Position != commanded;

    public void Define(double position) => Position = position;
}
