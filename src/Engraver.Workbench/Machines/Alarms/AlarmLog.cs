namespace Engraver.Workbench.Machines.Alarms;

/// <summary>The alarms since the program start, oldest first. A repeated cause increments the count of its alarm; the first of a series is marked
/// (first-out).</summary>
/// <remarks>Any thread. The log has no effect on the machine: acknowledging does not reset it.</remarks>
public sealed class AlarmLog(TimeProvider time)
{
    /// <summary>Maximum number of alarms; beyond it cleared ones are removed.</summary>
    private const int MaxKept = 500;

    private readonly Lock _guard = new();
    private readonly List<Alarm> _alarms = [];
    private int _number;

    /// <summary>Raised after an alarm was raised, acknowledged or cleared; on any thread.</summary>
    public event EventHandler? Changed;

    public IReadOnlyList<Alarm> All
    {
        get
        {
            lock (_guard) return [.. _alarms];
        }
    }

    /// <summary>Alarms that need attention: active, or cleared but not acknowledged.</summary>
    public IReadOnlyList<Alarm> Open => [.. All.Where(alarm => alarm.State != AlarmState.Cleared)];

    /// <summary>The first of the open alarms.</summary>
    public Alarm? FirstOut => Open.LastOrDefault(alarm => alarm.IsFirstOut) ?? (Open.Count > 0 ? Open[0] : null);

    /// <summary>Raises an alarm, or increments its count if the same cause at the same location is open. A cause that returns after acknowledgement must be
    /// acknowledged again.</summary>
    public Alarm Raise(AlarmCause cause, string what, string where, string toDo)
    {
        Alarm raised;
        lock (_guard)
        {
            var at = _alarms.FindLastIndex(alarm => alarm.Cause == cause && alarm.Where == where && alarm.State != AlarmState.Cleared);
            raised = at >= 0 ? RaiseAgain(_alarms[at], what, toDo) : RaiseNew(cause, what, where, toDo);
            if (at >= 0) _alarms[at] = raised;
            else _alarms.Add(raised);
            RemoveOldest();
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return raised;
    }

    /// <summary>Clears a cause. Its alarm stays open until it is acknowledged.</summary>
    public void Clear(AlarmCause cause) => Replace(alarm => alarm.Cause == cause && alarm.IsActive ? AsCleared(alarm) : alarm);

    /// <summary>Acknowledges an alarm. Resets nothing.</summary>
    /// <returns>False if there is no such alarm, or it needs no acknowledgement.</returns>
    public bool Acknowledge(int number) => Replace(alarm => alarm.Number == number ? AsAcknowledged(alarm) : alarm) > 0;

    /// <returns>The number of acknowledged alarms.</returns>
    public int AcknowledgeAll() => Replace(AsAcknowledged);

    private Alarm RaiseNew(AlarmCause cause, string what, string where, string toDo) =>
        new(++_number, time.GetUtcNow(), cause, what, where, toDo) { IsFirstOut = _alarms.TrueForAll(alarm => alarm.State == AlarmState.Cleared) };

    private Alarm RaiseAgain(Alarm alarm, string what, string toDo) => alarm with
    {
        What = what,
        ToDo = toDo,
        Count = alarm.Count + 1,
        LastTime = time.GetUtcNow(),
        State = alarm.State == AlarmState.Acknowledged ? AlarmState.Acknowledged : AlarmState.Unacknowledged,
    };

    private static Alarm AsCleared(Alarm alarm) => alarm with { State = alarm.State == AlarmState.Acknowledged ? AlarmState.Cleared : AlarmState.ClearedUnacknowledged };

    private static Alarm AsAcknowledged(Alarm alarm) => alarm.State switch
    {
        AlarmState.Unacknowledged => alarm with { State = AlarmState.Acknowledged },
        AlarmState.ClearedUnacknowledged => alarm with { State = AlarmState.Cleared },
        _ => alarm,
    };

    private int Replace(Func<Alarm, Alarm> change)
    {
        var changed = 0;
        lock (_guard)
        {
            for (var i = 0; i < _alarms.Count; i++)
            {
                var next = change(_alarms[i]);
                if (next == _alarms[i]) continue;
                _alarms[i] = next;
                changed++;
            }
        }

        if (changed > 0) Changed?.Invoke(this, EventArgs.Empty);
        return changed;
    }

    private void RemoveOldest()
    {
        while (_alarms.Count > MaxKept && _alarms.FindIndex(alarm => alarm.State == AlarmState.Cleared) is >= 0 and var oldest) _alarms.RemoveAt(oldest);
    }
}
