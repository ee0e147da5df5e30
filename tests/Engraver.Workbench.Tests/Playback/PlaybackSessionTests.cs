using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Playback;

public class PlaybackSessionTests
{
    private readonly ManualTimeProvider _time = new();
    private readonly PlaybackSession _playback;
    private readonly PlannedMotion _motion;

    public PlaybackSessionTests()
    {
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(10, 0, 110, 0).Line(0, 50, 90, 50).Build(), new DrawingSettings(), MotionStyle.Continuous);
        _motion = PlannedMotion.Create(job.Motion.Program!, job.Toolpath, MachineFamilies.Default.NetworkTimes, null, CancellationToken.None);
        _playback = new PlaybackSession(_time);
        _playback.Load(_motion);
    }

    [Fact]
    public void It_runs_by_the_clock_at_the_chosen_speed_and_stops_at_the_end()
    {
        _playback.Play();
        _time.Advance(TimeSpan.FromSeconds(2));
        Assert.Equal(2.0, _playback.Position, precision: 9);
        _playback.Speed = 3.0;
        _time.Advance(TimeSpan.FromSeconds(1));
        Assert.Equal(5.0, _playback.Position, precision: 9);
        Assert.True(_playback.IsPlaying);
        _time.Advance(TimeSpan.FromSeconds(1000));

        Assert.Equal((_motion.DurationSeconds, false), (_playback.Position, _playback.IsPlaying));
        _playback.Play();
        Assert.Equal(0.0, _playback.Position);
    }

    /// <summary>An unrequested mark on the canvas could be mistaken for the machine.</summary>
    [Fact]
    public void It_is_shown_while_it_plays_or_was_put_somewhere()
    {
        Assert.False(_playback.IsShown);
        _playback.Play();
        _time.Advance(TimeSpan.FromSeconds(1));
        Assert.True(_playback.IsShown);
        _playback.Pause();
        Assert.True(_playback.IsShown);
        _playback.Play();
        _time.Advance(TimeSpan.FromSeconds(1000));
        Assert.False(_playback.IsShown);
        _playback.Pause();
        Assert.False(_playback.IsShown);
        _playback.Scrub(_motion.DurationSeconds);
        Assert.True(_playback.IsShown);
        _playback.Scrub(0.0);
        Assert.False(_playback.IsShown);
        Assert.True(_playback.GoToStroke(1));
        Assert.True(_playback.IsShown);
        _playback.Follow(3.0);
        Assert.Equal((3.0, false), (_playback.Position, _playback.IsShown));
        Assert.True(_playback.GoToEntity(1));
        Assert.False(_playback.IsShown);
        _playback.Scrub(2.0);
        _playback.Load(_motion);
        Assert.False(_playback.IsShown);
    }

    [Fact]
    public void It_waits_while_paused_and_goes_on_from_there()
    {
        _playback.Play();
        _time.Advance(TimeSpan.FromSeconds(1));
        _playback.Pause();
        _time.Advance(TimeSpan.FromSeconds(10));
        Assert.Equal(1.0, _playback.Position, precision: 9);
        _playback.Play();
        _time.Advance(TimeSpan.FromSeconds(1));

        Assert.Equal(2.0, _playback.Position, precision: 9);
    }

    [Fact]
    public void Dragging_puts_it_anywhere_and_playing_goes_on()
    {
        _playback.Play();
        _playback.Scrub(4.0);
        _time.Advance(TimeSpan.FromSeconds(0.5));
        Assert.Equal(4.5, _playback.Position, precision: 9);
        _playback.Scrub(-1.0);
        Assert.Equal(0.0, _playback.Position, precision: 9);
        _playback.Scrub(1e9);
        Assert.Equal(_motion.DurationSeconds, _playback.Position);
    }

    [Fact]
    public void The_tool_goes_where_a_row_or_an_entity_or_a_stroke_is_named()
    {
        Assert.True(_playback.GoToEntity(1));
        Assert.Equal(1, _playback.Moment!.Value.Entity);
        Assert.True(_playback.GoToRow(0));
        Assert.Equal(0, _playback.Moment!.Value.Row);
        Assert.True(_playback.GoToStroke(1));
        Assert.Equal(1, _playback.Moment!.Value.Stroke);
        Assert.False(_playback.GoToEntity(77));
        Assert.False(_playback.GoToLine(1));
    }

    [Fact]
    public void At_full_speed_it_is_at_the_end_at_once()
    {
        _playback.Speed = double.PositiveInfinity;
        _playback.Play();

        Assert.Equal(_motion.DurationSeconds, _playback.Position);
        Assert.False(_playback.IsPlaying);
    }

    [Fact]
    public void Without_a_motion_there_is_nothing_to_play()
    {
        _playback.Load(null);
        _playback.Play();

        Assert.Equal((0.0, false, null), (_playback.Position, _playback.IsPlaying, _playback.Moment));
        Assert.Throws<ArgumentOutOfRangeException>(() => _playback.Speed = 0.0);
    }
}
