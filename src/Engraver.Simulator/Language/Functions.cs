namespace Engraver.Simulator.Language;

/// <summary>The @ functions (galil-dmc.md E): angles in degrees.</summary>
internal static class Functions
{
    private const double Degree = Math.PI / 180;

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
            "RND" => FixedPoint.FromInteger((argument.Raw + 0x8000) >> 16), // half goes up, also below zero: -5.5 -> -5
            "SQR" => FixedPoint.FromDouble(Math.Sqrt(Math.Abs(argument.Value))),
            "COM" => FixedPoint.FromInteger(~argument.Integer),
            "SIN" => FixedPoint.FromDouble(Math.Sin(argument.Value * Degree)),
            "COS" => FixedPoint.FromDouble(Math.Cos(argument.Value * Degree)),
            "TAN" => FixedPoint.FromDouble(Math.Tan(argument.Value * Degree)),
            "ASIN" => Inverse(Math.Asin(argument.Value)),
            "ACOS" => Inverse(Math.Acos(argument.Value)),
            "ATAN" => Inverse(Math.Atan(argument.Value)),
            "IN" => FixedPoint.FromBoolean(reader.Machine.Io.Input(argument.Integer)),
            "OUT" => FixedPoint.FromBoolean(reader.Machine.Io.Output(argument.Integer)),
            "AN" => throw new CommandRefusedException(Tc.AnalogAbsent),
            "FLOT" or "REAL" => throw new CommandRefusedException(Tc.BadFunction),
            _ => throw new CommandRefusedException(Tc.BadFunction),
        };
    }

    private static FixedPoint Inverse(double radians) =>
        double.IsNaN(radians) ? throw new CommandRefusedException(Tc.OutOfRange) : FixedPoint.FromDouble(radians / Degree);
}
