namespace Engraver.Simulator.Values;

/// <summary>A number of the controller: 32-bit signed integer part and 16-bit fraction, resolution 1/65536 (galil-dmc.md E, Number).</summary>
/// <remarks>Stored as value times 65536 in 48 bits; a value that does not fit wraps. A string is up to six characters in the same 48 bits.</remarks>
internal readonly record struct FixedPoint(long Raw)
{
    private const long One = 1L << 16;

    public static FixedPoint Zero => new(0);

    public static FixedPoint True => new(One);

    public double Value => Raw / (double)One;

    /// <summary>The integer part, towards zero (galil-dmc.md E, @INT).</summary>
    public int Integer => (int)(Raw / One);

    public bool IsTrue => Raw != 0;

    public static FixedPoint FromInteger(long value) => Wrap(value << 16);

    /// <summary>The nearest representable number.</summary>
    public static FixedPoint FromDouble(double value) => Wrap((long)Math.Round(value * One, MidpointRounding.AwayFromZero));

    public static FixedPoint FromBoolean(bool value) => value ? True : Zero;

    public static FixedPoint operator +(FixedPoint left, FixedPoint right) => Wrap(left.Raw + right.Raw);

    public static FixedPoint operator -(FixedPoint left, FixedPoint right) => Wrap(left.Raw - right.Raw);

    public static FixedPoint operator -(FixedPoint value) => Wrap(-value.Raw);

    public static FixedPoint operator *(FixedPoint left, FixedPoint right) => Wrap((long)((Int128)left.Raw * right.Raw / One));

    /// <summary>Division truncates: 2000/360 is 5.5555 (galil-dmc.md E, fixed-point traps). Division by zero is an operand error.</summary>
    public static FixedPoint operator /(FixedPoint left, FixedPoint right) =>
        right.Raw == 0 ? throw new CommandRefusedException(Tc.OperandError) : Wrap((long)((Int128)left.Raw * One / right.Raw));

    public static FixedPoint operator &(FixedPoint left, FixedPoint right) => new(left.Raw & right.Raw);

    public static FixedPoint operator |(FixedPoint left, FixedPoint right) => new(left.Raw | right.Raw);

    public static bool operator <(FixedPoint left, FixedPoint right) => left.Raw < right.Raw;

    public static bool operator >(FixedPoint left, FixedPoint right) => left.Raw > right.Raw;

    public static bool operator <=(FixedPoint left, FixedPoint right) => left.Raw <= right.Raw;

    public static bool operator >=(FixedPoint left, FixedPoint right) => left.Raw >= right.Raw;

    private static FixedPoint Wrap(long raw) => new((raw << 16) >> 16);
}
