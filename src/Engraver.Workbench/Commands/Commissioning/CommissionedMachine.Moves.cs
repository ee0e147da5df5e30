using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>Test moves: slow, with the tool off, each after a question that states axis, direction and distance.</summary>
internal sealed partial class CommissionedMachine
{
    /// <summary>Maximum speed of a test move, counts/s.</summary>
    private const double FastestTest = 20_000.0;

    /// <summary>Maximum deceleration time of a test move, seconds.</summary>
    private const double BrakingSeconds = 0.125;

    /// <summary>Speed of the test moves, counts/s, even.</summary>
    public int Speed { get; private set; } = 500;

    /// <summary>The machine in counts: one millimetre equals one count, because the scale is not known yet. Travel limits of the profile are
    /// respected.</summary>
    public MachineProfile Test
    {
        get
        {
            var step = MachineFamilies.DriverOf(Start).Limits.AccelerationStep;
            return Start with
            {
                Axes = new MachineAxes(InCounts(Start.Axes.X), InCounts(Start.Axes.Y), Start.Axes.Z is { } z ? InCounts(z) : null),
                Height = null, // Its heights are in millimetres, which are unknown yet: no lift or plunge.
                Spindle = null,
                FeedMmPerMinute = 60.0 * Speed,
                RapidMmPerMinute = 60.0 * Speed,
                JogMmPerMinute = 60.0 * Speed,
                AccelerationCounts = step * (int)Math.Ceiling(Speed / BrakingSeconds / step),
            };
        }
    }

    /// <summary>The same without a Z axis, so that drawing and switching cause no vertical motion.</summary>
    public MachineProfile TestPlane
    {
        get
        {
            var test = Test;
            return test with { Axes = test.Axes with { Z = null } };
        }
    }

    /// <summary>Asks for the speed of the next test moves.</summary>
    public async Task AskSpeedAsync()
    {
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterSpeed")) { Least = 10.0, Most = FastestTest, Whole = true, Default = NumberPrompt.Show(Speed) };
        Speed = 2 * (int)(await Context.ValueAsync(prompt).ConfigureAwait(false) / 2.0);
    }

    /// <summary>Moves one axis, after a question.</summary>
    /// <param name="letter">The axis.</param>
    /// <param name="counts">Signed.</param>
    /// <returns>False if it did not arrive; the reason was reported.</returns>
    public async Task<bool> MoveAsync(char letter, int counts, CancellationToken cancellation)
    {
        if (!await SwitchAllOnAsync(cancellation).ConfigureAwait(false)) return false;
        if (!await Context.ConfirmAsync(Wording.Get(counts > 0 ? "Commission.ConfirmMovePlus" : "Commission.ConfirmMoveMinus", letter, Math.Abs((long)counts), Speed)).ConfigureAwait(false)) return NotMoved();
        var place = (await ReadAsync(cancellation).ConfigureAwait(false)).Axes;
        var axis = Letters.IndexOf(letter, StringComparison.Ordinal);
        var goal = place[axis].Position + (long)counts;
        if (Math.Abs(goal) >= int.MaxValue)
        {
            Context.Say(Wording.Get("CncGoTo.PositionOutOfRange"), MessageKind.Warning);
            return false;
        }

        var to = CountsPoint.From([.. place.Select((other, i) => i == axis ? goal : (double)other.Position)]); // The other axes do not move.
        return await HasArrivedAsync(await Session.TestMoveAsync(to, Test, Context.NewRunJournal("commission"), cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    /// <summary>Draws a path from the current position. The caller has asked for confirmation.</summary>
    public async Task<bool> DrawAsync(MotionProgram path, CancellationToken cancellation) =>
        await HasArrivedAsync(await Session.TestPathAsync(path, Context.NewRunJournal("commission"), cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);

    /// <summary>Switches an output on for half a second. The caller has asked for confirmation.</summary>
    public async Task<bool> PulseAsync(int output, CancellationToken cancellation)
    {
        var test = TestPlane with { ToolOutput = output, ToolSettleSeconds = 0.5 };
        return await HasArrivedAsync(await Session.TestOutputAsync(test, Context.NewRunJournal("commission"), cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    /// <summary>Switches the motors off at once after uncommanded motion of an axis.</summary>
    /// <exception cref="CommandException">The link was lost.</exception>
    public async Task RanAwayAsync()
    {
        if (!Session.CanBeSetUp) throw new CommandException(CommandFailure.LinkLost, Wording.Get("Machine.NoControllerConnected"));
        await Session.SetMotorsAsync(on: false, CancellationToken.None).ConfigureAwait(false);
        foreach (var letter in Letters) _rewired.Add(letter);
        Context.Say(Wording.Get("Commission.RanAway"), MessageKind.Warning);
    }

    private bool NotMoved()
    {
        Context.Say(Wording.Get("Commission.NotMoved"));
        return false;
    }

    private static MachineAxis InCounts(MachineAxis axis) => axis with
    {
        CountsPerMillimetre = 1.0,
        Travel = TravelLimits.Of(axis) is { } limit ? new AxisTravel(limit.Least, limit.Most) : null,
        Homing = null, // The machine was homed by its own profile.
    };

    /// <returns>True if the motion finished; otherwise the reason was reported, and after a following error the motors are off.</returns>
    /// <exception cref="CommandException">The link was lost.</exception>
    /// <exception cref="OperationCanceledException">Esc during the motion.</exception>
    private async Task<bool> HasArrivedAsync(JobResult result, CancellationToken cancellation)
    {
        foreach (var left in result.NotRestored) Context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        cancellation.ThrowIfCancellationRequested();
        if (result.Outcome == JobOutcome.Complete) return true;
        if (result.Outcome == JobOutcome.LinkLost) throw new CommandException(CommandFailure.LinkLost, result.Sentence);
        Context.Say(result.Diagnostics is [{ } refusal, ..] ? SettingWording.AtCommandLine(refusal).Message : result.Sentence, MessageKind.Warning);
        var hasStarted = result.FinalPosition is not null;
        if (hasStarted && result.Outcome != JobOutcome.Stopped && (result.PositionDoubt.Length > 0 || (await ReadAsync(CancellationToken.None).ConfigureAwait(false)).Axes.Any(axis => axis.IsMotorOff))) await RanAwayAsync().ConfigureAwait(false);
        return false;
    }
}
