using System.Collections.Frozen;
using Engraver.Simulator.Language.Commands;
using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>The operands <c>_XX</c> (galil-dmc.md I.12).</summary>
internal static class Operands
{
    private static readonly FrozenDictionary<string, Func<OperandRequest, FixedPoint>> Table = new Dictionary<string, Func<OperandRequest, FixedPoint>>
    {
        ["LM"] = r => Whole(r.Plane.Buffer.FreeSlots),
        ["CS"] = r => Whole(r.Plane.Profile.SegmentIndex),
        ["AV"] = r => Length(r.Plane.Profile.Travelled),
        ["VM"] = r => Real(Math.Round(r.Plane.Profile.Speed)),
        ["VE"] = r => Length(r.Plane.Buffer.Length),
        ["LE"] = r => Length(r.Plane.Buffer.Length),
        ["VS"] = r => Real(r.Plane.Profile.VectorSpeed),
        ["VA"] = r => Real(r.Plane.Profile.Acceleration),
        ["VD"] = r => Real(r.Plane.Profile.Deceleration),
        ["VR"] = r => Real(r.Plane.Profile.SpeedRatio),
        ["TN"] = r => Real(Math.Round(r.Plane.Tangent.StartFor(r.Plane.Buffer.Current), MidpointRounding.AwayFromZero)),
        ["CA"] = r => Whole(r.Machine.Motion.Selected.Letter - 'S'),
        ["VP"] = r => Whole((r.Machine.Motion.PlaneOf(r.Axis) ?? r.Machine.Motion.Selected).JointOf(r.Axis)),
        ["BG"] = r => FixedPoint.FromBoolean(r.IsPlane ? r.Plane.IsActive : r.Machine.Motion.IsBusy(r.Axis)),
        ["RP"] = r => Whole(r.Axis.Reference),
        ["TP"] = r => Whole(r.Axis.Encoder),
        ["TD"] = r => Whole(r.Axis.SecondEncoder),
        ["TE"] = r => Whole(r.Axis.Error),
        ["TV"] = r => Real(Math.Round(r.Machine.Motion.VelocityOf(r.Axis))),
        ["TT"] = r => Whole(r.Axis.Index * 0),
        ["SC"] = r => Whole(r.Axis.StopCode),
        ["MO"] = r => FixedPoint.FromBoolean(r.Axis.MotorOff),
        ["LF"] = r => FixedPoint.FromBoolean(!r.Axis.Inputs.ForwardHit),
        ["LR"] = r => FixedPoint.FromBoolean(!r.Axis.Inputs.ReverseHit),
        ["HM"] = r => FixedPoint.FromBoolean(r.Axis.Inputs.Home),
        ["AL"] = r => FixedPoint.FromBoolean(r.Axis.Latch.IsArmed),
        ["RL"] = r => Whole(r.Axis.Latch.Position),
        ["CM"] = r => Whole(r.Machine.Motion.Contour.FreeRecords),
        ["DT"] = r => Whole(r.Machine.Motion.Contour.TimeExponent),
        ["RC"] = r => FixedPoint.FromBoolean(r.Machine.Capture.IsOn),
        ["RD"] = r => Whole(r.Machine.Capture.Next),
        ["EB"] = r => FixedPoint.FromBoolean(r.Machine.Motion.Cam.IsEnabled),
        ["EP"] = r => Whole(r.Machine.Motion.Cam.Interval),
        ["EC"] = r => Whole(r.Machine.Motion.Cam.Index),
        ["EM"] = r => Whole(CamCommands.CycleOf(r.Machine.Motion.Cam, r.Axis)),
        ["EG"] = r => FixedPoint.FromBoolean(r.Machine.Motion.IsOnCam(r.Axis)),
        ["EQ"] = r => Whole(r.Axis.Index < Axis.Real ? r.Machine.Motion.Cam.Followers[r.Axis.Index].Waiting : 0),
        ["TS"] = r => Whole(ReportCommands.StatusByte(r.Machine, r.Axis)),
        ["VT"] = r => Real(r.Plane.Smoothing),
        ["TB"] = r => Whole(r.Machine.StatusByte),
        ["TC"] = r => Whole(r.Machine.LastError),
        ["XQ"] = r => Whole(r.Machine.Threads[r.Number(7)] is { IsRunning: true } thread ? thread.Line : -1),
        ["HX"] = r => Whole(r.Machine.Threads[r.Number(7)] switch { { IsRunning: false } => 0, { Trippoint: null } => 1, _ => 2 }),
        ["NO"] = r => Whole(r.Machine.Threads.Running),
        ["ZS"] = r => Whole(r.Machine.Threads[r.Number(7)].Calls.Count),
        ["JS"] = r => r.Context.Thread?.ReturnValue ?? throw new CommandRefusedException(Tc.OnlyFromProgram),
        ["ED"] = ProgramError,
        ["TM"] = r => Whole(r.Machine.SampleMicroseconds),
        ["OP"] = r => Whole(r.Number(0) == 0 ? r.Machine.Io.Outputs : 0),
        ["TI"] = r => Whole(r.Number(0) == 0 ? r.Machine.Io.Inputs : 0),
        ["EO"] = r => FixedPoint.FromBoolean(r.Machine.Serial.Echo && r.Context.Handle is not { IsSerial: false }), // Ethernet never echoes (A.2)
        ["CF"] = r => Whole(r.Machine.Messages.Port),
        ["CW"] = r => Whole(r.Number(4) == 4 ? r.Machine.Messages.WhenBlocked : r.Machine.Messages.Marking),
        ["DR"] = r => Whole(r.Number(1) == 0 ? r.Machine.Records.Period : r.Machine.Records.HandleIndex),
        ["DL"] = r => Whole(r.Machine.Program.LabelsLeft),
        ["UL"] = r => Whole(VariableStore.MaximumVariables - r.Machine.Variables.Variables.Count),
        ["DM"] = r => Whole(r.Machine.Variables.ElementsLeft),
        ["DA"] = r => Whole(VariableStore.MaximumArrays - r.Machine.Variables.Arrays.Count),
        ["IA"] = Address,
        ["IH"] = HandleState,
        ["WH"] = r => Whole(r.Context.Handle?.Index ?? throw new CommandRefusedException(Tc.NotInProgram)),
        ["BN"] = r => Whole(r.Machine.Options.SerialNumber),
        ["BV"] = _ => Whole(Axis.Real),
        ["QZ"] = r => Whole(r.Number(3) switch { 0 => Axis.Real, 1 => 24, 2 => 16, _ => 28 }),
        ["AB"] = r => FixedPoint.FromBoolean(!r.Machine.IsAbortInputActive),
        ["CN"] = r => Whole(r.Machine.Motion.Polarity.Fields[r.Number(4)]),
        ["LZ"] = r => FixedPoint.FromBoolean(r.Machine.StripLeadingZeros),
        ["PF"] = r => r.Machine.PositionFormat.Argument,
        ["VF"] = r => r.Machine.VariableFormat.Argument,
    }.ToFrozenDictionary(StringComparer.Ordinal);

    private static readonly FrozenDictionary<string, Func<OperandRequest, FixedPoint>>.AlternateLookup<ReadOnlySpan<char>> Lookup =
        Table.GetAlternateLookup<ReadOnlySpan<char>>();

    public static IEnumerable<string> Names => Table.Keys;

    /// <summary>The operand after the underscore: two letters and a suffix, which may be a variable axis (<c>_TP~a</c>).</summary>
    public static FixedPoint Take(StatementReader reader)
    {
        var name = reader.TakeName();
        if (name.Length < 2) throw new CommandRefusedException(Tc.BadOperand);
        var suffix = reader.Next == '~' ? new OperandSuffix(reader.TakeLetter(), '\0', 1) : OperandSuffix.Parse(name[2..]);
        var request = new OperandRequest(reader.Machine, reader.Context, suffix);
        return Lookup.TryGetValue(name[..2], out var read) ? read(request)
            : AxisParameters.Find(name[..2]) is { } parameter ? parameter.Read(request.Axis)
            : throw new CommandRefusedException(Tc.BadOperand);
    }

    private static FixedPoint Whole(long value) => FixedPoint.FromInteger(value);

    private static FixedPoint Real(double value) => FixedPoint.FromDouble(value);

    /// <summary>A path length in whole counts; the tolerance of 1e-6 prevents rounding from reporting one count less at an exact end.</summary>
    private static FixedPoint Length(double value) => Whole((long)Math.Floor(value + 1e-6));

    private static FixedPoint ProgramError(OperandRequest request)
    {
        var (line, thread) = request.Machine.Threads.LastError;
        return request.Number(4) switch
        {
            0 => Whole(line),
            1 => Whole(thread),
            4 => Whole(request.Context.Thread?.Number ?? throw new CommandRefusedException(Tc.OnlyFromProgram)),
            _ => throw new CommandRefusedException(Tc.BadOperand),
        };
    }

    /// <summary>_IA0 address, _IA1 retry time, _IA2 free handles, _IA3 own handle, _IA4 handle lost last, _IA5 link speed (A.1).</summary>
    private static FixedPoint Address(OperandRequest request)
    {
        var handles = request.Machine.Handles;
        return Whole(request.Number(5) switch
        {
            0 => 0x7F000001,
            1 => 250,
            2 => handles.Free,
            3 => request.Context.Handle?.Index ?? -1,
            4 => handles.LostLast,
            _ => 10,
        });
    }

    /// <summary>_IHh0 address, _IHh1 remote port, _IHh2 state, _IHh3 ARP, _IHh4 last reply (A.1).</summary>
    private static FixedPoint HandleState(OperandRequest request)
    {
        var handles = request.Machine.Handles;
        if (request.Suffix.Length != 2 || request.Suffix.First < 'A' || request.Suffix.First >= 'A' + handles.Capacity)
            throw new CommandRefusedException(Tc.BadOperand);

        var handle = handles[request.Suffix.First - 'A'];
        return Whole(request.Suffix.Second switch
        {
            '0' => handle is null ? 0 : 0x7F000001,
            '1' => handle?.RemotePort ?? 0,
            '2' => handle is null ? 0 : handle.IsUdp ? 1 : 2,
            '3' => 0,
            '4' => 0,
            _ => throw new CommandRefusedException(Tc.BadOperand),
        });
    }
}
