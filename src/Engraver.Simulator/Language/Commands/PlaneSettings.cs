using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;
using static Engraver.Simulator.Language.Commands.VectorCommands;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Speeds and accelerations of the planes (galil-dmc.md B.1): by position or, except VR, by letter.</summary>
internal static class PlaneSettings
{
    private const double MinSmoothing = 0.004;

    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("VS", CommandScope.Both, r => PerPlane(r, p => p.Profile.VectorSpeed, (m, p, v) => p.Profile.SetSpeed(VectorSpeed(p, v, 2, 12_000_000, m.SamplesPerMillisecond)), letters: true), TakesLetter: true),
        new("VA", CommandScope.Both, r => PerPlane(r, p => p.Profile.Acceleration, (m, p, v) => p.Profile.Acceleration = AxisParameters.Acceleration(v, m.SamplesPerMillisecond), letters: true), TakesLetter: true),
        new("VD", CommandScope.Both, r => PerPlane(r, p => p.Profile.Deceleration, SetDeceleration, letters: true), TakesLetter: true),
        new("VR", CommandScope.Both, r => PerPlane(r, p => p.Profile.SpeedRatio, (_, p, v) => p.Profile.SpeedRatio = AxisParameters.InRange(v, 0, 10), letters: false), TakesLetter: true),
        new("VT", CommandScope.Both, r => PerPlane(r, p => p.Smoothing, (_, p, v) => p.Smoothing = AxisParameters.InRange(v, MinSmoothing, 1), letters: false)),
    ];

    private static void SetDeceleration(Machine machine, VectorPlane plane, double value)
    {
        Refuse(plane is { IsActive: true, Profile.IsStopping: false }, Tc.NotWhileRunning);
        plane.Profile.Deceleration = AxisParameters.Acceleration(value, machine.SamplesPerMillisecond);
    }

    public static double VectorSpeed(VectorPlane plane, double value, double smallest, double largest, double samplesPerMillisecond = 1)
    {
        var stepper = plane.Axes.Length > 0 && plane.Axes.ToArray().Any(a => a.IsStepper);
        return AxisParameters.Speed(value, smallest, stepper ? Math.Min(largest, 3_000_000) : largest, samplesPerMillisecond);
    }

    /// <summary><c>VS s,t</c>, <c>VSS=n</c>, <c>VS ?</c>, <c>VSS=?</c>; VR has no form with a letter (B.1).</summary>
    private static void PerPlane(StatementReader reader, Func<VectorPlane, double> read, Action<Machine, VectorPlane, double> write, bool letters)
    {
        var planes = reader.Machine.Motion.Planes;
        var fields = TakePlaneFields(reader, letters);
        reader.ExpectEnd();
        Refuse(fields.TrueForAll(f => f.IsMissing), Tc.NotEnoughFields);
        var printed = new List<string>();
        for (var i = 0; i < fields.Count; i++)
        {
            Refuse(i > 1 && !fields[i].IsMissing, Tc.PlaneNotValid);
            if (fields[i].IsQuery)
            {
                printed.Add(reader.Machine.Padded(new NumberFormat(10, letters ? 0 : 4, false, false)).Print(FixedPoint.FromDouble(read(planes[i]))));
            }
            else if (fields[i].Value is { } value)
            {
                write(reader.Machine, planes[i], value.Value);
            }
        }

        if (printed.Count > 0) reader.Context.WriteLine(ReportCommands.Join(printed));
    }

    private static List<Field> TakePlaneFields(StatementReader reader, bool letters)
    {
        if (reader.Next is not ('S' or 'T' or '~')) return reader.TakeFields();
        Refuse(!letters, Tc.Unrecognized);
        var fields = new List<Field> { default, default };
        var letter = reader.TakeLetter();
        Refuse(letter is not ('S' or 'T'), Tc.PlaneNotValid);
        reader.Take('=', Tc.OperandError);
        var field = reader.TakeField();
        fields[letter - 'S'] = field.IsMissing ? new Field(true, null) : field;
        return fields;
    }
}
