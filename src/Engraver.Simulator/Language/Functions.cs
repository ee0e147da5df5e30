using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>The @ functions (galil-dmc.md E): angles in degrees.</summary>
internal static class Functions
{
    private const double Degree = Math.PI / 180;
    private const double LargestAngle = 32768;

    public static FixedPoint Evaluate(StatementReader reader)
    {
        var name = reader.TakeName();
        reader.Take('[', Tc.MissingBracket);
        var argument = reader.TakeExpression();
        reader.Take(']', Tc.MissingBracket);
        return name switch
        {
            "ABS" => argument.Raw < 0 ? -argument : argument,
            "INT" => FixedPoint.FromInteger(argument.Integer),
            "FRAC" => argument - FixedPoint.FromInteger(argument.Integer),
            "RND" => FixedPoint.FromInteger((argument.Raw + 0x8000) >> 16), // a half is rounded up, also below zero: -5.5 -> -5
            "SQR" => FixedPoint.FromDouble(Math.Sqrt(Math.Abs(argument.Value))),
            "COM" => FixedPoint.FromInteger(~argument.Integer),
            "SIN" => FixedPoint.FromDouble(Math.Sin(Radians(argument))),
            "COS" => FixedPoint.FromDouble(Math.Cos(Radians(argument))),
            "TAN" => FixedPoint.FromDouble(Math.Tan(Radians(argument))),
            "ASIN" => Inverse(Math.Asin(argument.Value)),
            "ACOS" => Inverse(Math.Acos(argument.Value)),
            "ATAN" => Inverse(Math.Atan(argument.Value)),
            "IN" => FixedPoint.FromBoolean(reader.Machine.Io.Input(argument.Integer)),
            "OUT" => FixedPoint.FromBoolean(reader.Machine.Io.Output(argument.Integer)),
            "AN" => throw new CommandRefusedException(Tc.AnalogAbsent),
            "FLOT" => FixedPoint.FromInteger(BitConverter.SingleToInt32Bits((float)argument.Value)),
            "REAL" => Real(argument),
            _ => throw new CommandRefusedException(Tc.BadFunction),
        };
    }

    /// <summary>Radians; angles outside +-32768 degrees are out of range (E, Functions).</summary>
    private static double Radians(FixedPoint degrees) =>
        Math.Abs(degrees.Value) <= LargestAngle ? degrees.Value * Degree : throw new CommandRefusedException(Tc.OutOfRange);

    /// <summary>@REAL interprets the bits that @FLOT gives as an IEEE number of 32 bits [U].</summary>
    private static FixedPoint Real(FixedPoint bits)
    {
        var value = BitConverter.Int32BitsToSingle(bits.Integer);
        return Math.Abs(value) < int.MaxValue ? FixedPoint.FromDouble(value) : throw new CommandRefusedException(Tc.OutOfRange);
    }

    private static FixedPoint Inverse(double radians) =>
        double.IsNaN(radians) ? throw new CommandRefusedException(Tc.OutOfRange) : FixedPoint.FromDouble(radians / Degree);
}
