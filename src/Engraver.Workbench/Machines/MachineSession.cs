using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Machines;

/// <summary>The machine the operator works with: one controller, and what it is doing. One of the two objects that change over time (the other is the
/// document session).</summary>
/// <remarks>Composed of parts with one task each. What moves the machine is owned by <see cref="MotionInterlock"/>, the connection by
/// <see cref="Connection"/>, what is known of the machine by <see cref="MachineStatusModel"/>. Status, stop and abort may be used from any thread.</remarks>
public sealed class MachineSession : IAsyncDisposable
{
    private readonly MachineStatusModel _status;
    private readonly MotionInterlock _interlock;

    /// <param name="originsFolder">Where the work origins of machines are stored between two sessions; null: nowhere. A simulated machine ends with its
    /// connection, and so does what is known of it.</param>
    /// <param name="simulatedIsHomed">A simulated machine counts as homed and is at its machine zero: for one action on a machine that ends with it.
    /// Otherwise it is homed as a real one is.</param>
    /// <param name="families">The controller families that it can connect to; null: the standard ones.</param>
    public MachineSession(TimeProvider time, string? originsFolder = null, bool simulatedIsHomed = false, MachineFamilies? families = null)
    {
        _status = new MachineStatusModel(time, RaiseChanged);
        _interlock = new MotionInterlock(_status.ClearJob, RaiseChanged);
        Connection = new ConnectedMachine(time, _status, _interlock, Trail, originsFolder, simulatedIsHomed, families ?? MachineFamilies.Standard);
        Controls = new OperatorControls(Connection, _interlock, _status);
        Runs = new MachineRuns(Connection, _interlock, Controls, _status, time);
        Origins = new WorkOrigins(Connection, _interlock, Runs, _status);
        Hand = new HandMoves(Connection, Origins, Controls, _status, Trail, time);
        ReadyJogs = new ReadyJogs(Connection, _interlock, Hand, Controls, _status);
        Setup = new MachineSetup(Connection, _interlock, _status);
    }

    /// <summary>Raised when a connection or a job begins or ends, with each poll of the controller and each progress; on any thread.</summary>
    public event EventHandler? Changed;

    /// <summary>Connecting and disconnecting, and what is connected.</summary>
    public ConnectedMachine Connection { get; }

    /// <summary>Stop, abort, hold, resume and overrides.</summary>
    public OperatorControls Controls { get; }

    /// <summary>Jobs and frames.</summary>
    public MachineRuns Runs { get; }

    /// <summary>Work origins.</summary>
    public WorkOrigins Origins { get; }

    /// <summary>Moves by hand, homing, motors and outputs.</summary>
    public HandMoves Hand { get; }

    /// <summary>The jogs of a jog pad.</summary>
    public ReadyJogs ReadyJogs { get; }

    /// <summary>Wiring settings and test moves.</summary>
    public MachineSetup Setup { get; }

    /// <summary>The job that START would run, until it is disarmed.</summary>
    public ArmingSwitch Arming => _status.Arming;

    /// <summary>What is known of the machine now.</summary>
    public MachineStatus Status => _status.Status;

    public AlarmLog Alarms => _status.Alarms;

    /// <summary>The last positions of the machine, also while no job runs.</summary>
    public MachineTrail Trail { get; } = new();

    /// <summary>The machine profile, by which counts become millimetres and the tool's output is known. Setting another one disarms.</summary>
    public MachineProfile Profile
    {
        get => _status.Profile;
        set => _status.Profile = value;
    }

    /// <summary>A job or a move is under way.</summary>
    public bool IsRunning => _interlock.IsRunning;

    public async ValueTask DisposeAsync()
    {
        await _interlock.EndAsync().ConfigureAwait(false);
        await Connection.DisconnectAsync().ConfigureAwait(false);
        _status.Dispose();
    }

    private void RaiseChanged()
    {
        if (Status is { IsLinkLost: false, MachinePosition: { } at }) Trail.Add(at);
        Changed?.Invoke(this, EventArgs.Empty);
    }
}
