using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Posting;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Programs.Posting;

public class PostFindingsTests
{
    [Theory]
    [InlineData(MotionStyle.Continuous)]
    [InlineData(MotionStyle.Calls)]
    public void What_a_post_finds_is_known_without_writing_it(MotionStyle style)
    {
        var toolpath = new Toolpath(default, [Zigzag(0, 40), Zigzag(1, 9_000), Zigzag(2, 3), Zigzag(3, 2_500)]);
        var program = MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(0.001, 0.0), _ => new SourceRef(7, "A"), style).Program!;
        IPost post = style == MotionStyle.Calls ? GalilPost.Calls : GalilPost.Sequences;
        var request = UsualOptions.Post(toolpath, program, entity => new SourceRef(entity, "A"), new Dictionary<string, string>());
        var written = post.Write(request);

        Assert.NotEmpty(written.Diagnostics);
        Assert.Equal(written.Diagnostics.Select(found => found.Message), post.Findings(request).Select(found => found.Message));
        var small = request with { Options = new Dictionary<string, string> { ["memory"] = "150" } };
        Assert.Equal(post.Write(small).Diagnostics.Select(found => found.Message), post.Findings(small).Select(found => found.Message));
    }

    [Fact]
    public void No_stroke_has_more_lines_than_its_bound()
    {
        var toolpath = new Toolpath(default, [.. Enumerable.Range(0, 12).Select(i => Zigzag(i, 1 << i))]);
        var program = MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(0.001, 0.0), null).Program!;
        foreach (var stroke in program.Strokes)
        {
            var alone = DmcPost.Sequences(program with { Strokes = [stroke] }, DmcPostOptions.Default with { MemoryLines = 1_000_000 });
            var nothing = DmcPost.Sequences(program with { Strokes = [] }, DmcPostOptions.Default with { MemoryLines = 1_000_000 });
            Assert.InRange(Lines(alone) - Lines(nothing), 1, SequenceWriter.MaxLines(stroke));
        }
    }

    private static int Lines(PostOutput text) => text.Text.Count(character => character == '\n');

    /// <summary>Teeth of one millimetre; flat ones, so that many of them are one sequence, and every tenth sharp.</summary>
    private static ToolpathStroke Zigzag(int index, int segments)
    {
        var corners = Enumerable.Range(0, segments + 1).Select(i => new Point2D(i, (i % 10 == 5 ? 1.0 : 0.001 * (i % 2)) + (5.0 * index))).ToList();
        return new ToolpathStroke(index, false, [.. corners.Zip(corners.Skip(1), (from, to) => new StrokeMove(Segment.FromLine(from, to), index))]);
    }
}
