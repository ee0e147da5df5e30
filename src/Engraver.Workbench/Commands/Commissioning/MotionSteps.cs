using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Core.Machines.Setup;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Tests whether each axis moves and in which direction counts increase: the sign of its counts per millimetre.</summary>
internal sealed class DirectionStep : ICommissioningStep
{
    /// <summary>For X, Y and Z.</summary>
    private static readonly IReadOnlyList<Keyword>[] s_ways =
        [Keyword.List("Right", "Left", "Nothing", "Wild", "Keep"), Keyword.List("Back", "Front", "Nothing", "Wild", "Keep"), Keyword.List("Up", "Down", "Nothing", "Wild", "Keep")];

    public string Name => Wording.Get("Commission.DirectionStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        await machine.Moves.AskSpeedAsync().ConfigureAwait(false);
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterDistance")) { Least = 1.0, Most = 1e6, Whole = true, Default = machine.Context.Remembered("CNCCOMMISSION", "1000") };
        var counts = (int)await machine.Context.ValueAsync(prompt).ConfigureAwait(false);
        machine.Context.Remember("CNCCOMMISSION", NumberPrompt.Show(counts));
        for (var i = 0; i < machine.Letters.Length; i++)
        {
            if (!await AxisAsync(machine, machine.Profile.Axes.All[i].Letter, s_ways[i], counts, cancellation).ConfigureAwait(false)) return false;
        }

        return true;
    }

    /// <returns>False if something has to be repaired first.</returns>
    private static async Task<bool> AxisAsync(CommissionedMachine machine, char letter, IReadOnlyList<Keyword> ways, int counts, CancellationToken cancellation)
    {
        if (!await machine.Moves.MoveAsync(letter, counts, cancellation).ConfigureAwait(false)) return false;
        switch (await machine.Context.ChoiceAsync(Wording.Get("Commission.EnterObservedDirection", letter), ways, "Keep").ConfigureAwait(false))
        {
            case "Wild":
                await machine.Moves.RanAwayAsync().ConfigureAwait(false);
                return false;
            case "Nothing":
                machine.Context.Say(Wording.Get("Commission.AxisDidNotMove", letter), MessageKind.Warning);
                return false;
            case "Right" or "Back" or "Up": Turn(machine, letter, isPlus: true); break;
            case "Left" or "Front" or "Down": Turn(machine, letter, isPlus: false); break;
            default: break;
        }

        await machine.Moves.MoveAsync(letter, -counts, cancellation).ConfigureAwait(false); // it may stay there: which way it goes is known
        return true;
    }

    private static void Turn(CommissionedMachine machine, char letter, bool isPlus)
    {
        var axis = ProfileAxis.Of(machine.Profile, letter);
        if (axis.Scale.IsMirrored == isPlus) machine.Profile = ProfileAxis.With(machine.Profile, LetterF.Mirrored(axis));
        machine.Context.Say(Wording.Get(isPlus ? "Commission.CountsPlus" : "Commission.CountsMinus", letter), MessageKind.Result);
    }
}

/// <summary>Counts per millimetre of each axis, from a measured move.</summary>
internal sealed class ScaleStep : ICommissioningStep
{
    /// <summary>Default test distance of X and Y, and of Z, which may be near the table; mm.</summary>
    private const double UsualWay = 10.0;
    private const double UsualHeight = 1.0;

    public string Name => Wording.Get("Commission.ScaleStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        await machine.Moves.AskSpeedAsync().ConfigureAwait(false);
        var isMeasured = true;
        foreach (var letter in machine.Profile.Axes.Letters) isMeasured &= await AxisAsync(machine, letter, cancellation).ConfigureAwait(false);
        return isMeasured;
    }

    /// <returns>False if it did not move.</returns>
    private static async Task<bool> AxisAsync(CommissionedMachine machine, char letter, CancellationToken cancellation)
    {
        var axis = ProfileAxis.Of(machine.Profile, letter);
        var usual = Math.Clamp(Math.Round(axis.Scale.CountsOf(letter == machine.Profile.Axes.Z?.Letter ? UsualHeight : UsualWay)), 1.0, 1e7);
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterCountsToMeasure", letter)) { Least = 1.0, Most = 1e7, Whole = true, Default = NumberPrompt.Show(usual) };
        var counts = (int)await machine.Context.ValueAsync(prompt).ConfigureAwait(false);
        if (!await machine.Moves.MoveAsync(letter, counts, cancellation).ConfigureAwait(false)) return false;
        if (await machine.Context.AskAsync(new NumberPrompt(Wording.Get("Commission.EnterMeasuredDistance", letter)) { Least = 0.001, Most = 1e5, EnterEnds = true }).ConfigureAwait(false) is Answer<double>.Value { Of: var millimetres })
            Take(machine, axis with { CountsPerMillimetre = axis.Scale.Measured(counts, millimetres).CountsPerMillimetre });
        await machine.Moves.MoveAsync(letter, -counts, cancellation).ConfigureAwait(false);
        return true;
    }

    private static void Take(CommissionedMachine machine, MachineAxis axis)
    {
        var next = ProfileAxis.With(machine.Profile, axis);
        if (MachineProfileValidation.Check(next, MachineFamilies.DriverOf(next).Limits) is [{ } finding, ..])
        {
            machine.Context.Say(SettingWording.AtCommandLine(finding).Message, MessageKind.Warning);
            return;
        }

        machine.Context.Say(Wording.Get("Commission.ScaleSet", axis.Letter, axis.CountsPerMillimetre, ProfileAxis.Of(machine.Profile, axis.Letter).CountsPerMillimetre), MessageKind.Result);
        machine.Profile = next;
    }
}

/// <summary>Detects mirrored and swapped axes from a drawn letter F.</summary>
internal sealed class LetterStep : ICommissioningStep
{
    /// <summary>Limits of counts per millimetre: at 10 mm the letter would have too few counts, or too many for a path.</summary>
    private const double Coarsest = 1.0;
    private const double Finest = 100_000.0;

    private static readonly IReadOnlyList<Keyword> s_ways = Keyword.List("Right", "Left", "Back", "Front", "Keep");

    public string Name => Wording.Get("Commission.LetterStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        await machine.Moves.AskSpeedAsync().ConfigureAwait(false);
        if (!await machine.SwitchAllOnAsync(cancellation).ConfigureAwait(false)) return false;
        var drawn = machine.Profile.Axes;
        if (drawn.Scale.Coarser.CountsOf(1.0) < Coarsest || drawn.Scale.Finer.CountsOf(1.0) > Finest)
        {
            machine.Context.Say(Wording.Get("Commission.ScaleOutOfRangeForF", Coarsest, Finest), MessageKind.Warning);
            return false;
        }

        var farthest = drawn.Scale.ToCounts(new Point2D(LetterF.Width, LetterF.Height));
        if (!await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmDrawF", drawn.X.Letter, farthest.X, drawn.Y.Letter, farthest.Y, machine.Moves.Speed)).ConfigureAwait(false))
        {
            machine.Context.Say(Wording.Get("Commission.NotMoved"));
            return false;
        }

        if (!await machine.Moves.DrawAsync(LetterF.Program(machine.Moves.TestPlane, drawn, machine.Moves.Speed), cancellation).ConfigureAwait(false)) return false;
        if (await AskAsync(machine, "Commission.LongStrokeDirection").ConfigureAwait(false) is not { } longStroke || await AskAsync(machine, "Commission.BarsDirection").ConfigureAwait(false) is not { } bars) return true;
        if (LetterF.Corrected(drawn, longStroke, bars) is not { } axes)
        {
            machine.Context.Say(Wording.Get("Commission.ImpossibleLetter"), MessageKind.Warning);
            return false;
        }

        machine.Context.Say(Wording.Get(axes == drawn ? "Commission.LetterCorrect" : axes.X.Letter == drawn.X.Letter ? "Commission.LetterMirrored" : "Commission.LetterSwapped"), MessageKind.Result);
        machine.Profile = machine.Profile with { Axes = axes };
        return true;
    }

    /// <returns>Null: unchanged.</returns>
    private static async Task<TableDirection?> AskAsync(CommissionedMachine machine, string question) =>
        await machine.Context.ChoiceAsync(Wording.Get(question), s_ways, "Keep").ConfigureAwait(false) is var answer && answer != "Keep" ? Enum.Parse<TableDirection>(answer) : null;
}

/// <summary>Finds the output that switches the tool.</summary>
internal sealed class OutputStep : ICommissioningStep
{
    public string Name => Wording.Get("Commission.OutputStep");

    public async Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterToolOutput", machine.Profile.ToolOutput)) { Least = 1.0, Most = MachineFamilies.DriverOf(machine.Profile).Limits.Outputs, Whole = true, EnterEnds = true };
        while (await machine.Context.AskAsync(prompt).ConfigureAwait(false) is Answer<double>.Value { Of: var typed })
        {
            var output = (int)typed;
            if (!await machine.SwitchAllOnAsync(cancellation).ConfigureAwait(false)) return false;
            if (machine.Context.Machine.Status.Outputs is { } outputs && (outputs & (1 << (output - 1))) != 0)
            {
                machine.Context.Say(Wording.Get("Commission.OutputIsOn", output), MessageKind.Warning);
                continue;
            }

            if (!await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmOutput", output)).ConfigureAwait(false)) continue;
            if (!await machine.Moves.PulseAsync(output, cancellation).ConfigureAwait(false)) return false;
            if (!await machine.Context.ConfirmAsync(Wording.Get("Commission.ConfirmToolSwitched")).ConfigureAwait(false)) continue;
            machine.Profile = machine.Profile with { ToolOutput = output };
            machine.Context.Say(Wording.Get("Commission.ToolOutputSet", output), MessageKind.Result);
            break;
        }

        return true;
    }
}

/// <summary>An axis of a profile by its letter, whether X, Y or Z.</summary>
internal static class ProfileAxis
{
    public static MachineAxis Of(MachineProfile profile, char letter) => profile.Axes.All.First(axis => axis.Letter == letter);

    public static MachineProfile With(MachineProfile profile, MachineAxis axis) => profile with
    {
        Axes = profile.Axes.X.Letter == axis.Letter ? profile.Axes with { X = axis } : profile.Axes.Y.Letter == axis.Letter ? profile.Axes with { Y = axis } : profile.Axes with { Z = axis },
    };
}
