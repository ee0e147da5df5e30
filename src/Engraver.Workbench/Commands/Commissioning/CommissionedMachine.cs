using Engraver.Core.Machines;
using Engraver.Core.Machines.Setup;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>The machine being commissioned: its initial settings, the accepted changes, and the profile that results from the answers.</summary>
internal sealed partial class CommissionedMachine
{
    private readonly SetupFacts _found;
    private readonly HashSet<char> _rewired = [];
    private readonly List<string> _accepted = [];
    private bool _isLeft;

    private CommissionedMachine(CommandContext context, SetupFacts found)
    {
        (Context, _found) = (context, found);
        Start = Profile = context.Machine.Profile;
    }

    public CommandContext Context { get; }

    /// <summary>The profile used to poll and move the controller; it does not change before the end.</summary>
    public MachineProfile Start { get; }

    /// <summary>The profile that results from the answers.</summary>
    public MachineProfile Profile { get; set; }

    /// <summary>Whether a setting of the controller was changed.</summary>
    public bool HasAccepted => _accepted.Count > 0;

    public string Letters => Start.Axes.Letters;

    private MachineSession Session => Context.Machine;

    /// <exception cref="CommandException">The profile names an axis that this controller does not have.</exception>
    public static async Task<CommissionedMachine> FindAsync(CommandContext context, CancellationToken cancellation)
    {
        var letters = context.Machine.Profile.Axes.Letters;
        var known = MachineFamilies.DriverOf(context.Machine.Profile).Limits.Axes;
        var there = known[..Math.Min(known.Length, context.Machine.Identity!.Axes)];
        if (letters.Except(there).Any()) throw new CommandException(CommandFailure.Usage, context.Spell(Wording.Get("Commission.AxesDiffer", letters, there)));
        return new CommissionedMachine(context, await context.Machine.SetUpAsync(setup => setup.ReadAsync(letters, cancellation).AsTask(), cancellation).ConfigureAwait(false));
    }

    /// <summary>The current settings of the controller.</summary>
    public Task<SetupFacts> ReadAsync(CancellationToken cancellation) => SetUpAsync(setup => setup.ReadAsync(Letters, cancellation).AsTask(), cancellation);

    /// <summary>Sets a value that the operator has requested.</summary>
    /// <param name="said">Description of the setting for the final summary.</param>
    /// <returns>False if the controller does not support it; the reason was reported and the initial value is kept.</returns>
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
        Context.Say(why, MessageKind.Warning);
        return false;
    }

    public void Accepted(SetupValue value, string said)
    {
        if ((value switch { SetupValue.Motor motor => motor.Axis, SetupValue.Encoder encoder => encoder.Axis, _ => (char?)null }) is { } axis) _rewired.Add(axis);
        _accepted.Add(said);
        Context.Say(said, MessageKind.Result);
    }

    /// <summary>Switches a motor off, because its type can be set only then.</summary>
    /// <returns>False if the operator declines or the controller refuses.</returns>
    public async Task<bool> SwitchOffAsync(char axis, CancellationToken cancellation) =>
        (await ReadAsync(cancellation).ConfigureAwait(false))[axis].IsMotorOff
        || (await Context.ConfirmAsync(Wording.Get("Commission.ConfirmMotorOff", axis)).ConfigureAwait(false) && await SwitchAsync(axis, on: false).ConfigureAwait(false));

    /// <summary>Switches on the motors that are off, each after a question.</summary>
    /// <returns>False if one stays off: no move is possible.</returns>
    public async Task<bool> SwitchAllOnAsync(CancellationToken cancellation)
    {
        var facts = await ReadAsync(cancellation).ConfigureAwait(false);
        foreach (var axis in facts.Axes.Where(axis => axis.IsMotorOff))
        {
            if (!await Context.ConfirmAsync(Wording.Get(axis.OffOnError == true ? "Commission.ConfirmMotorOn" : "Commission.ConfirmMotorOnUnguarded", axis.Letter)).ConfigureAwait(false))
            {
                Context.Say(Wording.Get("Commission.MotorsNeeded"), MessageKind.Warning);
                return false;
            }

            if (!await SwitchAsync(axis.Letter, on: true).ConfigureAwait(false)) return false;
        }

        return true;
    }

    /// <summary>Restores the initial on or off state of the motors. A motor whose type or encoder was changed, or that ran away, stays off; this is
    /// reported.</summary>
    /// <remarks>A second call does nothing.</remarks>
    public async Task LeaveMotorsAsFoundAsync()
    {
        if (_isLeft) return;
        _isLeft = true;
        try
        {
            var now = await ReadAsync(CancellationToken.None).ConfigureAwait(false);
            foreach (var axis in _found.Axes.Where(axis => axis.IsMotorOff != now[axis.Letter].IsMotorOff))
            {
                if (axis.IsMotorOff || !_rewired.Contains(axis.Letter)) await SwitchAsync(axis.Letter, on: !axis.IsMotorOff).ConfigureAwait(false);
                else Context.Say(Context.Spell(Wording.Get("Commission.MotorStaysOff", axis.Letter)), MessageKind.Warning);
            }
        }
        catch (Exception failure) when (failure is ControllerException or CommandException)
        {
            Context.Say(Wording.Get("Commission.MotorsNotRestored", failure.Message), MessageKind.Warning);
        }
    }

    /// <summary>Reports which changed settings remain in the controller.</summary>
    /// <param name="isDone">The operator was already asked whether to burn them.</param>
    public void SayWhatStays(bool isDone)
    {
        if (isDone || !HasAccepted) return;
        Context.Say(Wording.Get("Commission.KeptUntilPowerOff"), MessageKind.Warning);
        foreach (var said in _accepted) Context.Say(said, MessageKind.Warning);
    }

    /// <exception cref="CommandException">The controller is no longer connected: the link was lost during a move.</exception>
    private Task<T> SetUpAsync<T>(Func<IMachineSetup, Task<T>> act, CancellationToken cancellation) =>
        Session.CanBeSetUp ? Session.SetUpAsync(act, cancellation) : throw new CommandException(CommandFailure.LinkLost, Wording.Get("Machine.NoControllerConnected"));

    private async Task<bool> SwitchAsync(char axis, bool on)
    {
        if (await SetUpAsync(setup => setup.SwitchMotorAsync(axis, on, CancellationToken.None), CancellationToken.None).ConfigureAwait(false) is not { } why) return true;
        Context.Say(why, MessageKind.Warning);
        if (on) _rewired.Add(axis);
        return false;
    }
}
