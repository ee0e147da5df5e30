using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.View;

public class PlaybackCommandTests
{
    [Fact]
    public async Task Playback_goes_to_a_row_a_stroke_a_handle_a_line_and_a_time()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var playback = talk.Session.Playback;
        await talk.TypeAsync("PLAYBACK", "Row", "3");
        Assert.Equal(2, playback.Moment!.Value.Row);
        await talk.TypeAsync("PLAYBACK", "C", "2");
        Assert.Equal(1, playback.Moment!.Value.Stroke);
        await talk.TypeAsync("PLAYBACK", "H", "A3");
        Assert.Equal(2, playback.Moment!.Value.Entity);
        var line = playback.Motion!.LineOf(playback.Moment.Value.Segment);
        await talk.TypeAsync("PLAYBACK", "Time", "0.5");
        Assert.Equal(0.5, playback.Position);
        await talk.TypeAsync("PLAYBACK", "L", FormattableString.Invariant($"{line}"));
        Assert.Equal(2, playback.Moment!.Value.Entity);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("PLAYBACK", "H", "FFFF"));
        Assert.Contains(FormattableString.Invariant($"program line {line}"), talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Play_pause_and_speed_work_by_word_and_an_edit_begins_anew()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("PLAYBACK", "S", "0.001", "PLAYBACK", "PL");
        Assert.True(talk.Session.Playback.IsPlaying);
        await talk.TypeAsync("PLAYBACK", "");
        Assert.False(talk.Session.Playback.IsPlaying);
        var before = talk.Session.Playback.Motion;
        await talk.TypeAsync("ERASE", "H", "A4", "", "PLAYBACK", "?");

        Assert.NotSame(before, talk.Session.Playback.Motion);
        Assert.Equal(0.0, talk.Session.Playback.Position);
    }

    [Fact]
    public async Task With_nothing_to_cut_there_is_nothing_to_play()
    {
        await using var talk = CommandTestSession.WithDrawing();

        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("LA", "OFF", "*", "", "PLAYBACK"));

        Assert.Equal((CommandFailure.Drawing, "The drawing has no curves to cut."), (failed.Reason, failed.Message));
    }
}
