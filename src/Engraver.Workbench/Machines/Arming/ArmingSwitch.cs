using Engraver.Core.Machines;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Arming;

/// <summary>The armed job, until it is started or disarmed, or its time has expired.</summary>
public sealed class ArmingSwitch(TimeProvider time, Action changed) : IDisposable
{
    /// <summary>A job stays armed for this long.</summary>
    public static readonly TimeSpan ArmingPeriod = TimeSpan.FromSeconds(60);

    private readonly Lock _guard = new();
    private ArmedJob? _armed;
    private ITimer? _end;

    /// <summary>Null if no job is armed.</summary>
    public ArmedJob? Armed
    {
        get
        {
            lock (_guard) return _armed is { } armed && time.GetUtcNow() < armed.Until ? armed : null;
        }
    }

    internal ArmedJob Arm(PreparedJob job, ExecutionStrategy strategy, bool dryRun, ArmingChecklist checklist)
    {
        var armed = new ArmedJob(job, strategy, dryRun, checklist, time.GetUtcNow() + ArmingPeriod);
        lock (_guard)
        {
            _end?.Dispose();
            _armed = armed;
            _end = time.CreateTimer(_ => Disarm(), null, ArmingPeriod, Timeout.InfiniteTimeSpan);
        }

        changed();
        return armed;
    }

    /// <summary>Disarms.</summary>
    /// <returns>False if no job was armed.</returns>
    public bool Disarm()
    {
        lock (_guard)
        {
            if (_armed is null) return false;
            _armed = null;
            _end?.Dispose();
            _end = null;
        }

        changed();
        return true;
    }

    public void Dispose()
    {
        lock (_guard) _end?.Dispose();
    }
}
