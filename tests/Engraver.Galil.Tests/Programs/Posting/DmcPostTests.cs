using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Posting;

namespace Engraver.Galil.Tests.Programs.Posting;

public class DmcPostTests
{
    private static readonly MachineProfile HundredCounts = MachineProfile.Default with { Axes = MachineAxes.FromScale(100, 100) };

    /// <summary>Too small for an arc of ten counts: corners are passed slowly.</summary>
    private const double Unrounded = 1e-6;

    [Fact]
    public void The_papers_part_by_calls()
    {
        var text = DmcPost.Calls(Program(Toolpaths.Paper, HundredCounts, MotionStyle.Calls), DmcPostOptions.Default).Text;

        Assert.Equal(
            """
            #JOB
            CB1;SHAB;ox=_RPA;oy=_RPB
            CAS;VA 256000;VD 256000
            ACA=256000;ACB=256000;DCA=256000;DCB=256000
            SPA=5000;SPB=5000
            f=2000;va=256000;seq=0
            x=5000;y=5000;JS#RAPID
            JS#TOOLON
            x=10000;y=0;JS#LINEAR
            x=0;y=10000;JS#LINEAR
            r=5000;th=0;da=180;va=254976;JS#CIRC
            x=0;y=-10000;JS#LINEAR
            JS#TOOLOFF
            CB1
            MG "DONE"
            EN
            #LINEAR
            VMAB
            VS f;VA va;VD va
            VP x,y
            VE
            BGS
            AMS
            f=2000;va=256000;seq=seq+1
            EN
            #CIRC
            VMAB
            VS f;VA va;VD va
            CR r,th,da
            VE
            BGS
            AMS
            f=2000;va=256000;seq=seq+1
            EN
            #RAPID
            PAA=ox+x;PAB=oy+y
            BGAB
            AMAB
            seq=seq+1
            EN
            #TOOLON
            SB1;WT 100
            seq=seq+1
            EN
            #TOOLOFF
            CB1;WT 100
            seq=seq+1
            EN
            #CMDERR
            CB1;STS;STAB
            MG "CMDERR",_ED,_TC
            HX0
            EN

            """.ReplaceLineEndings("\n"), text);
    }

    [Fact]
    public void The_papers_part_by_sequences_stops_at_its_two_square_corners()
    {
        var text = DmcPost.Sequences(Program(Toolpaths.Paper, HundredCounts, MotionStyle.Continuous), DmcPostOptions.Default).Text;

        Assert.Equal(
            """
            #JOB
            CB1;SHAB;ox=_RPA;oy=_RPB
            CAS;VA 256000;VD 256000
            ACA=256000;ACB=256000;DCA=256000;DCB=256000
            SPA=5000;SPB=5000
            PAA=ox+5000;PAB=oy+5000;BGAB;AMAB
            VMAB;VS 2000;VA 256000;VD 256000
            VP 10000,0
            VE;SB1;WT 100;BGS;AMS
            VMAB;VS 2000;VA 256000;VD 256000
            VP 0,10000;CR 5000,0,180;VP -10000,0
            VE;BGS;AMS
            CB1;WT 100
            CB1
            MG "DONE"
            EN
            #ROOM
            JP#ROOM,_LMS<50
            EN
            #CMDERR
            CB1;STS;STAB
            MG "CMDERR",_ED,_TC
            HX0
            EN

            """.ReplaceLineEndings("\n"), text);
    }

    [Fact]
    public void Only_the_first_chunk_takes_the_place_of_the_start()
    {
        var post = Post(Program(Rings(40), HundredCounts, MotionStyle.Continuous), DmcPostOptions.Default with { MemoryLines = 70 });

        Assert.True(post.Chunks.Count > 1);
        Assert.Equal([.. Enumerable.Repeat(1, 1), .. Enumerable.Repeat(0, post.Chunks.Count - 1)], post.Chunks.Select(chunk => Lines(chunk).Count(line => line.Contains("ox=_RPA", StringComparison.Ordinal))));
    }

    [Fact]
    public void Calls_of_a_program_that_was_aimed_for_sequences_are_a_mistake_of_ours() =>
        Assert.Throws<ArgumentException>(() => DmcPost.Calls(Program(Toolpaths.Paper, HundredCounts, MotionStyle.Continuous), DmcPostOptions.Default));

    [Theory]
    [InlineData(MotionStyle.Calls)]
    [InlineData(MotionStyle.Continuous)]
    public void Every_line_is_one_that_the_controller_takes(MotionStyle style)
    {
        var profile = new MachineProfile { Axes = MachineAxes.FromScale(-1999.7, 1999.7) };
        var post = Post(Program(Rings(40), profile, style), DmcPostOptions.Default);

        foreach (var line in Lines(post.Text))
        {
            Assert.InRange(line.Length, 1, 80);
            Assert.Matches("^('.*|#[A-Z]{1,7}|[A-Za-z].*)$", line);
            Assert.DoesNotMatch(@"\.\d{5}|//|MT|\d[eE][+-]?\d", line);
        }
    }

    [Fact]
    public void A_long_sequence_starts_when_the_buffer_is_nearly_full_and_is_fed_behind_the_guard()
    {
        var program = Program(Sawtooth(2000), MachineProfile.Default, MotionStyle.Continuous, Unrounded);

        var (buffered, started, sinceRoom) = (0, false, 0);
        foreach (var statement in Lines(DmcPost.Sequences(program, DmcPostOptions.Default).Text).TakeWhile(line => line != "EN").SelectMany(line => line.Split(';')))
        {
            if (statement == "BGS") (started, sinceRoom) = (true, 50);
            if (statement == "JS#ROOM") sinceRoom = 0;
            if (!statement.StartsWith("VP ", StringComparison.Ordinal)) continue;
            if (started) Assert.InRange(++sinceRoom, 1, 50);
            else buffered++;
        }

        Assert.InRange(buffered, 400, 480);
        Assert.True(started);
    }

    [Theory]
    [InlineData(MotionStyle.Calls)]
    [InlineData(MotionStyle.Continuous)]
    public void A_job_longer_than_the_memory_comes_in_chunks_that_are_complete_and_cut_between_strokes(MotionStyle style)
    {
        var program = Program(Rings(60), MachineProfile.Default, style);
        var post = Post(program, DmcPostOptions.Default with { MemoryLines = 120 });

        Assert.True(post.Chunks.Count > 1);
        Assert.Empty(post.Diagnostics);
        for (var i = 0; i < post.Chunks.Count; i++)
        {
            var lines = Lines(post.Chunks[i]);
            Assert.InRange(lines.Count, 1, 120);
            Assert.Equal($"'CHUNK {i + 1} OF {post.Chunks.Count}", lines[0]);
            Assert.Equal(1, lines.Count(line => line == "#JOB"));
            Assert.Equal(1, lines.Count(line => line == "#CMDERR"));
            Assert.Equal(lines.Count(line => line.Contains("SB1", StringComparison.Ordinal)), style == MotionStyle.Calls ? 1 : lines.Count(line => line.StartsWith("PAA=", StringComparison.Ordinal)));
        }

        Assert.Equal(Cuts(Post(program, DmcPostOptions.Default with { MemoryLines = 1_000_000 }).Text), Cuts(post.Text));
    }

    [Fact]
    public void Every_chunk_of_calls_counts_on_from_the_one_before()
    {
        var post = Post(Program(Rings(60), MachineProfile.Default, MotionStyle.Calls), DmcPostOptions.Default with { MemoryLines = 120 });

        var calls = 0;
        foreach (var chunk in post.Chunks)
        {
            Assert.Contains($"seq={calls}\n", chunk, StringComparison.Ordinal);
            calls += Lines(chunk).Count(line => line.Contains("JS#", StringComparison.Ordinal));
        }
    }

    [Theory]
    [InlineData(MotionStyle.Calls)]
    [InlineData(MotionStyle.Continuous)]
    public void A_stroke_longer_than_the_memory_is_cut_with_the_tool_off_and_the_entity_is_named(MotionStyle style)
    {
        var program = Program(Sawtooth(3000), MachineProfile.Default, style, Unrounded);
        var post = DmcPostOf(style)(program, DmcPostOptions.Default with { MemoryLines = 200 }, entity => new SourceRef(1000 + entity));

        Assert.Equal(post.Chunks.Count - 1, post.Diagnostics.Count);
        Assert.All(post.Diagnostics, finding => Assert.Equal(("MOT0007", true), (finding.Id, finding.Source.Line > 1000)));
        Assert.All(post.Chunks, chunk => Assert.InRange(Lines(chunk).Count, 1, 200));
        Assert.Equal(program.SegmentCount, post.Chunks.Sum(Cuts));
    }

    [Fact]
    public void A_sequence_cut_by_the_memory_goes_on_from_where_it_stopped()
    {
        var program = Program(Sawtooth(3000), MachineProfile.Default, MotionStyle.Continuous, Unrounded);
        var post = DmcPost.Sequences(program, DmcPostOptions.Default with { MemoryLines = 200 });

        var (x, y) = (0, 0);
        foreach (var chunk in post.Chunks)
        {
            var statements = Lines(chunk).SelectMany(line => line.Split(';')).ToList();
            Assert.Equal(($"PAA=ox{x:+0;-0}", $"PAB=oy{y:+0;-0}"), (statements.Single(s => s.StartsWith("PAA=", StringComparison.Ordinal)), statements.Single(s => s.StartsWith("PAB=", StringComparison.Ordinal))));
            var last = statements.Last(s => s.StartsWith("VP ", StringComparison.Ordinal))[3..].Split('<')[0].Split(',');
            x += int.Parse(last[0], System.Globalization.CultureInfo.InvariantCulture);
            y += int.Parse(last[1], System.Globalization.CultureInfo.InvariantCulture);
        }

        Assert.Equal((3000 * 100, 0), (x, y));
    }

    private static MotionProgram Program(Toolpath toolpath, MachineProfile profile, MotionStyle style, double corner = 0.0) =>
        MotionProgramGenerator.Generate(toolpath, profile, new(0.001, corner), null, style).Program ?? throw new InvalidOperationException("The toolpath should be good.");

    private static Func<MotionProgram, DmcPostOptions, Func<int, SourceRef>?, PostOutput> DmcPostOf(MotionStyle style) => style == MotionStyle.Calls ? DmcPost.Calls : DmcPost.Sequences;

    private static PostOutput Post(MotionProgram program, DmcPostOptions options) => DmcPostOf(program.Style)(program, options, null);

    private static List<string> Lines(string text) => [.. text.TrimEnd('\n').Split('\n')];

    /// <summary>Number of segments in the job part of a text.</summary>
    private static int Cuts(string text) => Lines(text).SelectMany(line => line.Split(';')).Count(s =>
        s is "JS#LINEAR" or "JS#CIRC" || (s.Length > 3 && (s[..3] is "VP " or "CR ") && (char.IsDigit(s[3]) || s[3] == '-')));

    private static Toolpath Rings(int count) => Toolpaths.OfStrokes([.. Enumerable.Range(0, count).Select(i => new[]
    {
        Toolpaths.Arc(i, 2 * i, 0.7 + (0.013 * i), 0, 123.4567),
        Toolpaths.Arc(i, 2 * i, 0.7 + (0.013 * i), 123.4567, 360 - 123.4567),
    })]);

    private static Toolpath Sawtooth(int count) => Toolpaths.OfStroke(
        [.. Enumerable.Range(0, count).Select(i => Toolpaths.Line(0.1 * i, 0.05 * (i % 2), 0.1 * (i + 1), 0.05 * ((i + 1) % 2)))]);
}
