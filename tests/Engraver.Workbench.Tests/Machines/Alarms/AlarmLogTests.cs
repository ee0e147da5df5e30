using Engraver.TestKit;
using Engraver.Workbench.Machines.Alarms;

namespace Engraver.Workbench.Tests.Machines.Alarms;

public class AlarmLogTests
{
    private readonly ManualTimeProvider _time = new();
    private readonly AlarmLog _log;

    public AlarmLogTests() => _log = new AlarmLog(_time);

    [Fact]
    public void The_same_trouble_again_is_counted_and_not_listed_again()
    {
        Raise(AlarmCause.LinkLost, "tcp://a");
        _time.Advance(TimeSpan.FromSeconds(5));
        Raise(AlarmCause.LinkLost, "tcp://a");
        Raise(AlarmCause.LinkLost, "tcp://b");

        Assert.Equal([2, 1], _log.All.Select(alarm => alarm.Count));
        Assert.Equal(TimeSpan.FromSeconds(5), _log.All[0].LastTime - _log.All[0].Time);
    }

    [Fact]
    public void The_first_of_a_series_stays_marked_until_all_are_gone_and_seen()
    {
        Raise(AlarmCause.Limit, "A");
        Raise(AlarmCause.JobStopped, "A");
        _log.Clear(AlarmCause.Limit);

        Assert.Equal(AlarmCause.Limit, _log.FirstOut!.Cause);
        Assert.Equal([true, false], _log.Open.Select(alarm => alarm.IsFirstOut));

        _log.Clear(AlarmCause.JobStopped);
        _log.AcknowledgeAll();
        Raise(AlarmCause.Refused, "A");
        Assert.Equal(AlarmCause.Refused, _log.FirstOut!.Cause);
    }

    [Fact]
    public void An_alarm_goes_through_its_states_either_way()
    {
        Raise(AlarmCause.Limit, "A");
        Assert.Equal(AlarmState.Unacknowledged, _log.All[0].State);
        Assert.True(_log.Acknowledge(1));
        Assert.False(_log.Acknowledge(1));
        Assert.Equal(AlarmState.Acknowledged, _log.All[0].State);
        _log.Clear(AlarmCause.Limit);
        Assert.Equal(AlarmState.Cleared, _log.All[0].State);

        Raise(AlarmCause.Limit, "A");
        _log.Clear(AlarmCause.Limit);
        Assert.Equal((2, AlarmState.ClearedUnacknowledged), (_log.All.Count, _log.All[1].State));
        Assert.Equal(1, _log.AcknowledgeAll());
        Assert.Empty(_log.Open);
    }

    [Fact]
    public void A_flood_of_old_alarms_is_forgotten_and_open_ones_never_are()
    {
        Raise(AlarmCause.Limit, "stands");
        for (var i = 0; i < 600; i++)
        {
            Raise(AlarmCause.Refused, FormattableString.Invariant($"{i}"));
            _log.Clear(AlarmCause.Refused);
            _log.Acknowledge(i + 2);
        }

        Assert.Equal(500, _log.All.Count);
        Assert.Equal("stands", _log.Open.Single().Where);
    }

    private void Raise(AlarmCause cause, string where) => _log.Raise(cause, "what", where, "do");
}
