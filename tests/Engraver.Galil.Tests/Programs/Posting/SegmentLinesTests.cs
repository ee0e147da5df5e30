using Engraver.Core.Machines;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Posting;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Programs.Posting;

public class SegmentLinesTests
{
    [Theory]
    [InlineData(MotionStyle.Continuous, "VP ", "CR ")]
    [InlineData(MotionStyle.Calls, "JS#LINEAR", "JS#CIRC")]
    public void Each_segment_has_the_line_that_commands_it(MotionStyle style, string line, string arc)
    {
        var toolpath = Toolpaths.Paper;
        var program = MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(0.001, 0.0), null, style).Program!;
        var post = style == MotionStyle.Calls ? GalilPost.Calls : GalilPost.Sequences;
        var written = post.Write(UsualOptions.Post(toolpath, program, null, new Dictionary<string, string>()));
        var lines = written.Text.Split('\n');
        var segments = program.Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(sequence => sequence.Segments).ToList();

        Assert.Equal(segments.Count, written.SegmentLines.Count);
        Assert.All(segments.Zip(written.SegmentLines), pair => Assert.Contains(pair.First.Kind == VectorSegmentKind.Line ? line : arc, lines[pair.Second - 1], StringComparison.Ordinal));
        Assert.Equal(written.SegmentLines.Order(), written.SegmentLines);
    }
}
