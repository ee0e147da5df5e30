using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>The machine's status as seen by an operator across several hosts: informed about jobs and moves like a machine session, and about the controller by
/// polls.</summary>
internal sealed class OperatorView(MachineProfile profile) : IDisposable
{
    private readonly MachineStatusModel _model = new(TimeProvider.System, static () => { }) { Profile = profile };
    private readonly HashSet<MachineState> _meanwhile = [];

    public MachineStatus Status => _model.Status;

    /// <summary>States shown during a job or a move.</summary>
    public IReadOnlySet<MachineState> Meanwhile => _meanwhile;

    /// <summary>The alarms since the start of the last job or move.</summary>
    public IReadOnlyList<Alarm> Alarms => _model.Alarms.Open;

    public void Connected(string link, MachineIdentity identity)
    {
        if (Status.Link is null) _model.Connected(link, isSimulation: false, identity);
    }

    /// <summary>A job or a manual move starts.</summary>
    /// <param name="move">Null for a job.</param>
    public void Start(string? move)
    {
        _model.Alarms.AcknowledgeAll();
        _meanwhile.Clear();
        if (move is null) _model.JobStarted(isDryRun: false);
        else _model.MoveStarted(move);
    }

    public void Progress(JobProgress value, bool isJob)
    {
        if (isJob) _model.JobProgressed(value);
        else _model.MoveProgressed(value);
        _meanwhile.Add(Status.State);
    }

    /// <summary>It has ended; the controller was not polled yet.</summary>
    /// <param name="result">Null if the link could not be established.</param>
    public void End(JobResult? result, bool isJob)
    {
        if (result is not null && isJob) _model.JobEnded(result);
        else if (result is not null) _model.MoveEnded(result);
        _model.ClearJob();
    }

    /// <summary>The controller was polled.</summary>
    public void Poll(MachineReading reading, MachineLease hold, ControllerPosition place)
    {
        hold.CompareZero(place);
        _model.SetHomed(profile.HasHoming ? hold.IsHomed(profile) : null, hold.Memory.HomingIsAssumed);
        _model.SetOriginMissing(WorkPlacement.Find(hold.Memory, place, new OriginRequest.ActiveOrigin(), profile, default).Refusal);
        _model.Polled(reading);
    }

    public void Dispose() => _model.Dispose();
}
