using System.Text.Json;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs;

namespace Engraver.Galil.Tests.Jobs;

public class JournalTests
{
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task The_journal_has_a_header_a_line_for_each_sequence_and_an_end(JobMode mode)
    {
        var lines = await JournalOfAsync(MotionPrograms.TwoStrokes, SimulatedBench.Job with { Mode = mode, DrawingName = "two.dxf" });

        Assert.Equal(["found", "job", "opened", .. mode == JobMode.Program ? (string[])[] : ["opened"], "end"], lines.Select(line => line.GetProperty("kind").GetString()).Where(kind => kind != "progress"));
        Assert.Equal("VAS=256000", lines[0].GetProperty("state").GetProperty("motion").EnumerateArray().Single(setting => setting.GetProperty("operand").GetString() == "_VAS").GetProperty("restoreCommand").GetString());
        lines.RemoveAt(0);
        Assert.Equal(("two.dxf", "DMC2143 Rev 1.0o", 2), (lines[0].GetProperty("drawing").GetString(), lines[0].GetProperty("controller").GetString(), lines[0].GetProperty("segmentCount").GetInt32()));
        var progress = lines.Where(line => line.GetProperty("kind").GetString() == "progress").Select(At).ToList();
        Assert.Contains((0, 7, 1), progress);
        Assert.Equal((1, 3, 2), progress[^1]);
        Assert.Equal(("complete", 2, 0.0), (lines[^1].GetProperty("outcome").GetString(), lines[^1].GetProperty("cut").GetInt32(), lines[^1].GetProperty("along").GetDouble()));
    }

    [Fact]
    public async Task A_long_sequence_is_journalled_while_it_is_cut()
    {
        var lines = await JournalOfAsync(MotionPrograms.ShortLines(1600), SimulatedBench.Job);

        var executed = lines.Where(line => line.GetProperty("kind").GetString() == "progress").Select(line => line.GetProperty("segmentsExecuted").GetInt32()).ToList();
        Assert.InRange(executed.Count, 16, 40);
        Assert.Equal(executed.Order(), executed);
        Assert.Equal(1600, executed[^1]);
    }

    [Fact]
    public async Task A_journal_on_a_full_disk_ends_the_job_before_anything_moves_and_says_why()
    {
        if (OperatingSystem.IsWindows()) return; // no device is always full there
        await using var bench = new SimulatedBench();
        var folder = Directory.CreateTempSubdirectory();
        var full = Path.Combine(folder.FullName, "job.jsonl");
        File.CreateSymbolicLink(full, "/dev/full");

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { JournalPath = full });
        folder.Delete(recursive: true);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("The journal cannot be written: the disk is full", result.Sentence, StringComparison.Ordinal);
        Assert.Equal(0, bench.Controller.Status.Outputs);
        Assert.Equal((0, 0), (result.SegmentsSent, bench.Controller.Record.Count));
    }

    private static (int Stroke, int Entity, int Executed) At(JsonElement line) =>
        (line.GetProperty("stroke").GetInt32(), line.GetProperty("entity").GetInt32(), line.GetProperty("segmentsExecuted").GetInt32());

    private static async Task<List<JsonElement>> JournalOfAsync(Engraver.Core.Machines.MotionProgram program, JobOptions options)
    {
        await using var bench = new SimulatedBench();
        var folder = Directory.CreateTempSubdirectory();
        var path = Path.Combine(folder.FullName, "job.jsonl");
        await bench.RunAsync(program, options with { JournalPath = path });
        var lines = (await File.ReadAllLinesAsync(path)).Select(line => JsonSerializer.Deserialize<JsonElement>(line)).ToList();
        folder.Delete(recursive: true);
        return lines;
    }
}
