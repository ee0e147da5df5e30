using Engraver.Core.Machines;
using Engraver.Core.Machines.Setup;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>The machine that is being commissioned: its state when it was found, what was accepted since, and the profile that the answers describe so
/// far.</summary>
internal sealed class CommissionedMachine
{
    private readonly SetupFacts _found;
    private readonly HashSet<char> _rewired = [];
    private readonly List<string> _accepted = [];
    private bool _isRestored;

    private CommissionedMachine(CommandContext context, SetupFacts found)
    {
        (Context, _found) = (context, found);
        Start = Profile = context.Machine.Profile;
        Moves = new TestMoves(this);
    }

    public CommandContext Context { get; }

    public TestMoves Moves { get; }

    /// <summary>The profile used to poll and move the controller; it does not change before the end.</summary>
    public MachineProfile Start { get; }

    /// <summary>The profile that results from the answers.</summary>
    public MachineProfile Profile { get; set; }

    /// <summary>Whether a setting of the controller was changed.</summary>
    public bool HasAccepted => _accepted.Count > 0;

    public string Letters => Start.Axes.Letters;

    private MachineSetup Setup => Context.Machine.Setup;

    /// <exception cref="CommandException">The profile names an axis that this controller does not have.</exception>
    public static async Task<CommissionedMachine> FindAsync(CommandContext context, CancellationToken cancellation)
    {
        var letters = context.Machine.Profile.Axes.Letters;
        var known = MachineFamilies.DriverOf(context.Machine.Profile).Limits.Axes;
        var there = known[..Math.Min(known.Length, context.Machine.Connection.Identity!.Axes)];
        if (letters.Except(there).Any()) throw new CommandException(CommandFailure.Usage, context.ApplyTerminology(Wording.Get("Commission.AxesDiffer", letters, there)));
        return new CommissionedMachine(context, await context.Machine.Setup.ApplyAsync(setup => setup.ReadAsync(letters, cancellation).AsTask(), cancellation).ConfigureAwait(false));
    }

    /// <summary>The wiring settings of the controller now.</summary>
    public Task<SetupFacts> ReadAsync(CancellationToken cancellation) => SetUpAsync(setup => setup.ReadAsync(Letters, cancellation).AsTask(), cancellation);

    /// <summary>Sets a value that the operator has requested.</summary>
    /// <param name="said">Description of the setting for the final summary.</param>
    /// <returns>False when the controller does not have it; the reason was reported, and the earlier value is set again.</returns>
    public async Task<bool> AcceptAsync(SetupValue value, string said, CancellationToken cancellation)
    {
        if (!await TryAsync(value, cancellation).ConfigureAwait(false)) return false;
        Accepted(value, said);
        return true;
    }

    /// <summary>Sets a value that the operator has not accepted yet.</summary>
    public async Task<bool> TryAsync(SetupValue value, CancellationToken cancellation)
    {
        if (await SetUpAsync(setup => setup.SetAsync(value, cancellation), CancellationToken.None).ConfigureAwait(false) is not { } why) return true;
        Context.WriteMessage(why, MessageKind.Warning);
        return false;
    }

    public void Accepted(SetupValue value, string said)
    {
        if ((value switch { SetupValue.Motor motor => motor.Axis, SetupValue.Encoder encoder => encoder.Axis, _ => (char?)null }) is { } axis) _rewired.Add(axis);
        _accepted.Add(said);
        Context.WriteMessage(said, MessageKind.Result);
    }

    /// <summary>Switches a motor off, because the controller takes its type only then.</summary>
    /// <returns>False if the operator declines or the controller refuses.</returns>
    public async Task<bool> SwitchOffAsync(char axis, CancellationToken cancellation) =>
        (await ReadAsync(cancellation).ConfigureAwait(false))[axis].IsMotorOff
        || (await Context.ConfirmAsync(Wording.Get("Commission.ConfirmMotorOff", axis)).ConfigureAwait(false) && await SwitchAsync(axis, on: false).ConfigureAwait(false));

    /// <summary>Switches on the motors that are off, each after a question.</summary>
    /// <returns>False when one of them stays off: then nothing can be moved.</returns>
    public async Task<bool> SwitchAllOnAsync(CancellationToken cancellation)
    {
        var facts = await ReadAsync(cancellation).ConfigureAwait(false);
        foreach (var axis in facts.Axes.Where(axis => axis.IsMotorOff))
        {
            if (!await Context.ConfirmAsync(Wording.Get(axis.OffOnError == true ? "Commission.ConfirmMotorOn" : "Commission.ConfirmMotorOnUnguarded", axis.Letter)).ConfigureAwait(false))
            {
                Context.WriteMessage(Wording.Get("Commission.MotorsNeeded"), MessageKind.Warning);
                return false;
            }

            if (!await SwitchAsync(axis.Letter, on: true).ConfigureAwait(false)) return false;
        }

        return true;
    }

    /// <summary>Switches motors off that were found off, and those on that were found on. A motor whose type or encoder was changed, and one that ran away,
    /// is not switched on by this program: it stays off, which is reported.</summary>
    /// <remarks>A second call does nothing.</remarks>
    public async Task RestoreMotorsAsync()
    {
        if (_isRestored) return;
        _isRestored = true;
        try
        {
            var now = await ReadAsync(CancellationToken.None).ConfigureAwait(false);
            foreach (var axis in _found.Axes.Where(axis => axis.IsMotorOff != now[axis.Letter].IsMotorOff))
            {
                if (axis.IsMotorOff || !_rewired.Contains(axis.Letter)) await SwitchAsync(axis.Letter, on: !axis.IsMotorOff).ConfigureAwait(false);
                else Context.WriteMessage(Context.ApplyTerminology(Wording.Get("Commission.MotorStaysOff", axis.Letter)), MessageKind.Warning);
            }
        }
        catch (Exception failure) when (failure is ControllerException or CommandException)
        {
            Context.WriteMessage(Wording.Get("Commission.MotorsNotRestored", failure.Message), MessageKind.Warning);
        }
    }

    /// <summary>Motors that are off now stay off at the end.</summary>
    public void LeaveMotorsOff() => _rewired.UnionWith(Letters);

    /// <summary>Reports which settings stay in the controller.</summary>
    /// <param name="isDone">The operator was already asked whether to burn them.</param>
    public void WriteChangedSettings(bool isDone)
    {
        if (isDone || !HasAccepted) return;
        Context.WriteMessage(Wording.Get("Commission.KeptUntilPowerOff"), MessageKind.Warning);
        foreach (var said in _accepted) Context.WriteMessage(said, MessageKind.Warning);
    }

    /// <exception cref="CommandException">The controller is no longer connected, because the link was lost in a move.</exception>
    private Task<T> SetUpAsync<T>(Func<IMachineSetup, Task<T>> change, CancellationToken cancellation) =>
        Setup.IsPossible ? Setup.ApplyAsync(change, cancellation) : throw new CommandException(CommandFailure.LinkLost, Wording.Get("Machine.NoControllerConnected"));

    private async Task<bool> SwitchAsync(char axis, bool on)
    {
        if (await SetUpAsync(setup => setup.SwitchMotorAsync(axis, on, CancellationToken.None), CancellationToken.None).ConfigureAwait(false) is not { } why) return true;
        Context.WriteMessage(why, MessageKind.Warning);
        if (on) _rewired.Add(axis);
        return false;
    }
}
