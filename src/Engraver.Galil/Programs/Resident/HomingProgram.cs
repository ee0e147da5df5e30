using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Subprograms;
using Variables = Engraver.Galil.Programs.Resident.ResidentProgram.Variables;

namespace Engraver.Galil.Programs.Resident;

/// <summary>#HOME in thread 0: homes the axes one after the other by JG, BG and the inputs (galil-dmc.md C.1, C.2, EX8), and sets the zero of each.</summary>
/// <remarks> An explicit program and not HM or FE: those choose their direction by the level of the input, creep at a speed that cannot be set on the 21x3, and
/// ignore limit switches (C.2). Steps for each axis: off the switch, if the axis is on it; towards the switch at the fast speed until it is hit; back at the
/// slow speed until it is released: this edge is the mark. If the mark is an index pulse, the axis continues slowly until the latch has captured it (ALT; C,
/// AL). At rest DP sets the machine position of the mark; then the axis backs off. Every wait also ends when the axis stops for another reason. </remarks>
internal static class HomingProgram
{
    public const string Entry = "#HOME";

    /// <summary>1 when every axis is homed.</summary>
    public const string Done = "hok";

    /// <summary>Reason of an early end; one of <see cref="HomingFault"/>, 0 for none.</summary>
    public const string Fault = "herr";

    /// <summary>Index, in the order of homing, of the axis that is being homed.</summary>
    public const string Axis = "hax";

    /// <summary>The change of an axis' counts, by its index in the order of homing.</summary>
    public static string Shift(int place) => DmcFormat.Text($"hs{(char)('a' + place)}");

    /// <summary>The axes to be homed, in their order.</summary>
    public static IReadOnlyList<MachineAxis> Axes(MachineProfile profile) => [.. profile.Axes.All.Where(axis => axis.Homing is not null).OrderBy(axis => axis.Homing!.Order)];

    public static IReadOnlyList<string> Lines(MachineProfile profile)
    {
        var axes = Axes(profile);
        var lines = new ProgramLines()
            .Line(Entry)
            .Line(CommandErrorProgram.ClearStatement, $"{Done}=0;{Fault}=0;{Axis}=0;{Variables.Go}=0")
            .Line([.. axes.Select((_, place) => $"{Shift(place)}=0")])
            .Line(WatchdogProgram.StartStatement)
            .Line("#HWAIT")
            .Line("WT 2")
            .Line($"JP#HWAIT,{Variables.Go}=0");
        for (var place = 0; place < axes.Count; place++) lines.Line($"{Axis}={place};JS#HAX{place}").Line($"JP#HEND,{Fault}<>0");
        lines.Line($"{Done}=1").Line("#HEND").Line("WT 10").Line("JP#HEND").Line("EN");
        for (var place = 0; place < axes.Count; place++) new AxisSubprogram(lines, axes[place], place).Add();
        return lines.Lines;
    }

    private static int Counts(double exact) => (int)Math.Round(exact, MidpointRounding.AwayFromZero);

    /// <summary>The subprogram #HAXn of one axis.</summary>
    private sealed class AxisSubprogram(ProgramLines lines, MachineAxis axis, int place)
    {
        private readonly AxisHoming _homing = axis.Homing!;
        private readonly bool _forward = axis.Homing!.Plus != axis.Scale.IsMirrored;
        private readonly int _fast = axis.AxisSpeed(axis.Homing!.FastMmPerMinute);
        private readonly int _slow = axis.AxisSpeed(axis.Homing!.SlowMmPerMinute);
        private readonly char _letter = axis.Letter;

        public void Add()
        {
            lines.Line($"#HAX{place}");
            if (_homing.HasSwitch) FindEdge();
            if (_homing.HasIndex) FindIndex();
            SetZero();
        }

        /// <summary>Moves off the switch, onto it, and back over its edge.</summary>
        private void FindEdge()
        {
            var input = _homing.ByLimit ? $"_L{(_forward ? 'F' : 'R')}{_letter}" : $"_HM{_letter}";
            var (on, off) = _homing.ByLimit ? ("=0", "<>0") : ($"={_homing.OnSwitch}", $"<>{_homing.OnSwitch}");
            lines.Line($"JP#HS{place},{input}{off}");
            Move("#HL", -_fast, $"{input}{off}", HomingFault.NotLeft);
            Brake();
            lines.Line($"#HS{place}");
            Move("#HT", _fast, $"{input}{on}", HomingFault.NotFound);
            Brake();
            lines.Line($"JP#HB{place},{input}{on}").Line(DmcFormat.Text($"{Fault}={(int)HomingFault.Passed}")).Line("EN").Line($"#HB{place}");
            Move("#HE", -_slow, $"{input}{off}", HomingFault.NoEdge);
            lines.Line($"hp=_RP{_letter};ST{_letter}").Line("AM" + _letter);
        }

        private void FindIndex()
        {
            lines.Line($"ALT{_letter}");
            Move("#HI", _homing.HasSwitch ? -_slow : _slow, $"_AL{_letter}=0", HomingFault.NoIndex);
            Brake();
            lines.Line($"hp=_RL{_letter}");
        }

        /// <summary>Sets the machine position of the mark; then the axis backs off.</summary>
        private void SetZero()
        {
            var zero = Counts(axis.Scale.Exact(_homing.Zero));
            var rest = Counts(axis.Scale.Exact(_homing.Zero + ((_homing.Plus ? -1.0 : 1.0) * _homing.BackOff)));
            lines.Line("WT 100") // pulses of a stepper lag the profile (galil-dmc.md C, KS)
                .Line(DmcFormat.Text($"DP{_letter}=_RP{_letter}-hp+{zero}"))
                .Line(DmcFormat.Text($"{Shift(place)}={zero}-hp"))
                .Line(DmcFormat.Text($"SP{_letter}={_fast};PA{_letter}={rest}"))
                .Line("BG" + _letter)
                .Line("AM" + _letter)
                .Line(DmcFormat.Text($"JP#HZ{place},_RP{_letter}={rest}"))
                .Line(DmcFormat.Text($"{Fault}={(int)HomingFault.NoBackOff}"))
                .Line($"#HZ{place}")
                .Line("EN");
        }

        private void Brake() => lines.Line("ST" + _letter).Line("AM" + _letter);

        /// <summary>Moves the axis until the condition is true; the lines after it run while it still moves.</summary>
        /// <param name="speed">Counts per second; positive towards the switch.</param>
        private void Move(string label, int speed, string until, HomingFault otherwise) => lines
            .Line(DmcFormat.Text($"JG{_letter}={(_forward ? speed : -speed)}"))
            .Line("BG" + _letter)
            .Line($"{label}{place}")
            .Line($"JP{label}F{place},{until}")
            .Line($"JP{label}{place},_BG{_letter}=1")
            .Line(DmcFormat.Text($"{Fault}={(int)otherwise}"))
            .Line("EN")
            .Line($"{label}F{place}");
    }
}
