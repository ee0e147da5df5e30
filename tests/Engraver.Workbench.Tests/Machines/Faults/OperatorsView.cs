using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>What the machine's status tells an operator while hosts come and go: told of jobs and moves as a machine session tells it, and of the
/// controller by looks of its own.</summary>
internal sealed class OperatorsView(MachineProfile profile) : IDisposable
{
    private readonly MachineStatusModel _model = new(TimeProvider.System, static () => { }) { Profile = profile };
    private readonly HashSet<MachineState> _meanwhile = [];

    public MachineStatus Status => _model.Status;

    /// <summary>What was told while a job or a move was under way.</summary>
    public IReadOnlySet<MachineState> Meanwhile => _meanwhile;

    /// <summary>The alarms since the last job or move began.</summary>
    public IReadOnlyList<Alarm> Alarms => _model.Alarms.Open;

    public void Connected(string link, MachineIdentity identity)
    {
        if (Status.Link is null) _model.Connected(link, isSimulation: false, identity);
    }

    /// <summary>A job begins, or a move by hand.</summary>
    /// <param name="move">Null for a job.</param>
    public void Begins(string? move)
    {
        _model.Alarms.AcknowledgeAll();
        _meanwhile.Clear();
        if (move is null) _model.JobBegins(isDryRun: false);
        else _model.MoveBegins(move);
    }

    public void Tells(JobProgress value, bool isJob)
    {
        if (isJob) _model.JobTells(value);
        else _model.MoveTells(value);
        _meanwhile.Add(Status.State);
    }

    /// <summary>It has ended; nothing was looked at yet.</summary>
    /// <param name="result">Null where the link never came up.</param>
    public void Ends(JobResult? result, bool isJob)
    {
        if (result is not null && isJob) _model.JobEnds(result);
        else if (result is not null) _model.MoveEnds(result);
        _model.JobIsOver();
    }

    /// <summary>The controller was looked at.</summary>
    public void Sees(MachineReading reading, MachineHold hold, ControllerPlace place)
    {
        hold.Recognise(place);
        _model.HomedIs(profile.HasHoming ? hold.IsHomed(profile) : null, hold.Memory.HomingIsAssumed);
        _model.OriginIs(WorkPlacement.Find(hold.Memory, place, new OriginRequest.Work(), profile, default).Refusal);
        _model.Seen(reading);
    }

    public void Dispose() => _model.Dispose();
}
