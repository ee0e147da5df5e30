using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>The test moves of a machine that is being commissioned: each slow, with the tool off, and after a question that states what moves where and how
/// far.</summary>
internal sealed class TestMoves(CommissionedMachine machine)
{
    /// <summary>Maximum speed of a test move, counts/s.</summary>
    private const double FastestTest = 20_000.0;

    /// <summary>Maximum deceleration time of a test move, seconds.</summary>
    private const double BrakingSeconds = 0.125;

    private CommandContext Context => machine.Context;

    private MachineProfile Start => machine.Start;

    private MachineSession Session => machine.Context.Machine;

    /// <summary>Speed of the test moves, counts/s, even.</summary>
    public int Speed { get; private set; } = 500;

    /// <summary>The machine in counts: one count per millimetre, because the real number is only being determined. A travel in the profile is
    /// respected.</summary>
    public MachineProfile Test
    {
        get
        {
            var step = MachineFamilies.DriverOf(Start).Limits.AccelerationStep;
            return Start with
            {
                Axes = new MachineAxes(InCounts(Start.Axes.X), InCounts(Start.Axes.Y), Start.Axes.Z is { } z ? InCounts(z) : null),
                Height = null, // heights in millimetres are not known yet: nothing is lifted or plunged by them
                Spindle = null,
                FeedMmPerMinute = 60.0 * Speed,
                RapidMmPerMinute = 60.0 * Speed,
                JogMmPerMinute = 60.0 * Speed,
                AccelerationCounts = step * (int)Math.Ceiling(Speed / BrakingSeconds / step),
            };
        }
    }

    /// <summary>The same without a tool axis: nothing that is drawn or switched with it moves up or down.</summary>
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
        var prompt = new NumberPrompt(Wording.Get("Commission.EnterSpeed")) { Min = 10.0, Max = FastestTest, IsInteger = true, Default = NumberPrompt.Format(Speed) };
        Speed = 2 * (int)(await Context.ValueAsync(prompt).ConfigureAwait(false) / 2.0);
    }

    /// <summary>Moves one axis, after a question.</summary>
    /// <param name="letter">The axis.</param>
    /// <param name="counts">Signed.</param>
    /// <returns>False when it did not arrive; the reason was reported.</returns>
    public async Task<bool> MoveAsync(char letter, int counts, CancellationToken cancellation)
    {
        if (!await machine.SwitchAllOnAsync(cancellation).ConfigureAwait(false)) return false;
        if (!await Context.ConfirmAsync(Wording.Get(counts > 0 ? "Commission.ConfirmMovePlus" : "Commission.ConfirmMoveMinus", letter, Math.Abs((long)counts), Speed)).ConfigureAwait(false)) return NotMoved();
        var place = (await machine.ReadAsync(cancellation).ConfigureAwait(false)).Axes;
        var axis = machine.Letters.IndexOf(letter, StringComparison.Ordinal);
        var goal = place[axis].Position + (long)counts;
        if (Math.Abs(goal) >= int.MaxValue)
        {
            Context.WriteMessage(Wording.Get("CncGoTo.PositionOutOfRange"), MessageKind.Warning);
            return false;
        }

        var to = CountsPoint.From([.. place.Select((other, i) => i == axis ? goal : (double)other.Position)]); // The other axes do not move.
        return await HasArrivedAsync(await Session.Setup.TestMoveAsync(to, Test, Context.NewRunJournal("commission"), cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    /// <summary>Follows a path from the machine's position, after a question that the caller has asked.</summary>
    public async Task<bool> DrawAsync(MotionProgram path, CancellationToken cancellation) =>
        await HasArrivedAsync(await Session.Setup.TestPathAsync(path, Context.NewRunJournal("commission"), cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);

    /// <summary>Switches an output on for half a second. The caller has asked for confirmation.</summary>
    public async Task<bool> PulseAsync(int output, CancellationToken cancellation)
    {
        var test = TestPlane with { ToolOutput = output, ToolSettleSeconds = 0.5 };
        return await HasArrivedAsync(await Session.Setup.TestOutputAsync(test, Context.NewRunJournal("commission"), cancellation).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    /// <summary>Switches the motors off at once: an axis moved without a command.</summary>
    /// <exception cref="CommandException">The link was lost.</exception>
    public async Task RanAwayAsync()
    {
        if (!Session.Setup.IsPossible) throw new CommandException(CommandFailure.LinkLost, Wording.Get("Machine.NoControllerConnected"));
        await Session.Hand.SetMotorsAsync(on: false, CancellationToken.None).ConfigureAwait(false);
        machine.LeaveMotorsOff();
        Context.WriteMessage(Wording.Get("Commission.RanAway"), MessageKind.Warning);
    }

    private bool NotMoved()
    {
        Context.WriteMessage(Wording.Get("Commission.NotMoved"));
        return false;
    }

    private static MachineAxis InCounts(MachineAxis axis) => axis with
    {
        CountsPerMillimetre = 1.0,
        Travel = TravelLimits.Of(axis) is { } limit ? new AxisTravel(limit.Min, limit.Max) : null,
        Homing = null, // its own profile states how it was homed
    };

    /// <returns>True for a complete motion; otherwise the reason was reported, and after a following error the motors are off.</returns>
    /// <exception cref="CommandException">The link was lost.</exception>
    /// <exception cref="OperationCanceledException">Esc during the motion.</exception>
    private async Task<bool> HasArrivedAsync(JobResult result, CancellationToken cancellation)
    {
        foreach (var left in result.NotRestored) Context.WriteMessage(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        cancellation.ThrowIfCancellationRequested();
        if (result.Outcome == JobOutcome.Complete) return true;
        if (result.Outcome == JobOutcome.LinkLost) throw new CommandException(CommandFailure.LinkLost, result.Message);
        Context.WriteMessage(result.Diagnostics is [{ } refusal, ..] ? SettingWording.AtCommandLine(refusal).Message : result.Message, MessageKind.Warning);
        var hasStarted = result.FinalPosition is not null;
        if (hasStarted && result.Outcome != JobOutcome.Stopped && (result.PositionDoubt.Length > 0 || (await machine.ReadAsync(CancellationToken.None).ConfigureAwait(false)).Axes.Any(axis => axis.IsMotorOff))) await RanAwayAsync().ConfigureAwait(false);
        return false;
    }
}
