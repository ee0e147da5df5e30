using System.Runtime.CompilerServices;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Documents;

public class DocumentWeightTests
{
    private const int Lines = 20_000;

    /// <summary>One segment for each line: corners are not rounded.</summary>
    private static readonly DrawingSettings s_stopping = new() { CornerToleranceMm = 0.0 };

    [Fact]
    public void Planning_a_line_allocates_a_bounded_number_of_bytes_and_posts_nothing()
    {
        var state = new DocumentState { Drawing = Squares(Lines / 4), Settings = s_stopping };
        _ = DerivedDocument.Create(state, JobMode.Stream.Strategy(), CancellationToken.None);
        var before = GC.GetAllocatedBytesForCurrentThread();
        var derived = DerivedDocument.Create(state, JobMode.Stream.Strategy(), CancellationToken.None);
        var bytes = (double)(GC.GetAllocatedBytesForCurrentThread() - before) / Lines;

        Assert.Equal(Lines, derived.Motion!.SegmentCount);
        Assert.False(derived.IsPosted);
        Assert.InRange(bytes, 100.0, 3_000.0);
        Assert.NotEmpty(derived.Program!.Text);
        Assert.True(derived.IsPosted);
    }

    [Fact]
    public void What_is_kept_of_a_planned_line_is_bounded()
    {
        var state = new DocumentState { Drawing = Squares(Lines / 4), Settings = s_stopping };
        var program = DerivedDocument.Create(state, JobMode.Stream.Strategy(), CancellationToken.None).Job!.Motion.Program!;
        var columns = new VectorColumns(Lines);
        var segments = program.Strokes.SelectMany(stroke => stroke.Sequences).Select(sequence => (sequence.Speed, Segments: sequence.Segments.ToArray())).ToList();
        var before = GC.GetAllocatedBytesForCurrentThread();
        foreach (var (speed, of) in segments) columns.Append(speed, 256000, of, changesHeight: false);
        var bytes = (double)(GC.GetAllocatedBytesForCurrentThread() - before) / columns.SegmentCount;

        Assert.Equal(Lines, columns.SegmentCount);
        Assert.InRange(bytes, 16.0, 60.0);
    }

    [Fact]
    public async Task Closing_a_drawing_releases_what_followed_from_it()
    {
        await using var talk = CommandTestSession.WithDrawing();
        talk.Session.Derivation.IsAutomatic = true;
        var (job, motion) = await PlannedAsync(talk);
        await talk.TypeAsync("CLOSE");
        await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);

        Assert.Null(talk.Session.Derivation.Current.Job);
        Assert.True(await IsReleasedAsync(job) && await IsReleasedAsync(motion));
    }

    [Fact]
    public async Task A_drawing_that_is_opened_again_shares_its_columns_with_what_undo_keeps()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        var first = talk.State.Drawing!;
        await talk.TypeAsync("CLOSE");
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        var again = talk.State.Drawing!;

        Assert.NotSame(first, again);
        Assert.Same(first.Parts, again.Parts);
        Assert.Same(first.Entities, again.Entities);
        await talk.TypeAsync("ERASE", "All", "");
        await talk.TypeAsync("CLOSE");
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));
        Assert.NotSame(first.Parts, talk.State.Drawing!.Parts);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static async Task<(WeakReference Job, WeakReference Motion)> PlannedAsync(CommandTestSession talk)
    {
        var derived = await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);
        return (new WeakReference(derived.Job), new WeakReference(derived.Motion));
    }

    /// <summary>Background work (the certificate check) may keep it alive a little longer.</summary>
    private static async Task<bool> IsReleasedAsync(WeakReference held)
    {
        for (var look = 0; look < 2_000 && held.IsAlive; look++)
        {
            await Task.Yield();
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }

        return !held.IsAlive;
    }

    private static Drawing Squares(int count)
    {
        var sheet = new DrawingBuilder();
        for (var i = 0; i < count; i++)
        {
            var (x, y) = (12.0 * (i % 100), 12.0 * (i / 100));
            sheet.Line(x, y, x + 10, y).Line(x + 10, y, x + 10, y + 10).Line(x + 10, y + 10, x, y + 10).Line(x, y + 10, x, y);
        }

        return sheet.Build();
    }
}
