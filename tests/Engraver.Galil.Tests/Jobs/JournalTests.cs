using System.Text.Json;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs;

public class JournalTests
{
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task The_journal_has_a_header_a_line_for_each_sequence_and_an_end(JobMode mode)
    {
        var lines = await JournalOfAsync(MotionPrograms.TwoStrokes, SimulatedBench.Job with { Strategy = mode.Strategy(), DrawingName = "two.dxf" });

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
        Assert.Contains("The journal cannot be written: the disk is full", result.Message, StringComparison.Ordinal);
        Assert.Equal(0, bench.Controller.Status.Outputs);
        Assert.Equal((0, 0), (result.SegmentsSent, bench.Controller.Record.Count));
    }

    /// <summary>Regression: the job was ended, and its part lost.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_journal_that_can_no_longer_be_written_does_not_end_the_job_and_that_is_told_at_once(JobMode mode)
    {
        if (OperatingSystem.IsWindows()) return; // no named pipes in a folder there
        await using var bench = new SimulatedBench();
        var folder = Directory.CreateTempSubdirectory();
        var pipe = NamedPipe.Make(Path.Combine(folder.FullName, "job.jsonl"));
        var gone = Task.Factory.StartNew(() => { using var reader = new StreamReader(pipe); while (reader.ReadLine() is { } line && !line.Contains("\"kind\":\"job\"", StringComparison.Ordinal)) { } }, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        var told = new List<(string Id, int Outputs)>();
        var options = SimulatedBench.Job with { Strategy = mode.Strategy(), JournalPath = pipe, Polled = point => gone.Wait(point.ToolOn ? Timeout.Infinite : 0), Warned = finding => told.Add((finding.Rule.Id, bench.Controller.Status.Outputs)) };

        var result = await bench.RunAsync(MotionPrograms.LongLine(200000), options);
        folder.Delete(recursive: true);

        Assert.Equal((JobOutcome.Complete, 1), (result.Outcome, result.SegmentsExecuted));
        Assert.Equal("JOB0051", Assert.Single(told).Id);
        Assert.Equal(0, bench.Controller.Status.Outputs);
    }

    [Fact]
    public void A_journal_that_was_given_up_keeps_what_was_found_and_says_that_its_job_cannot_be_resumed()
    {
        var path = Path.GetTempFileName();
        using (var disk = new FullDisk(path))
        using (var journal = new JobJournal(disk))
        {
            Begin(journal);
            while (disk.Room > 0) Progress(journal, disk);
            journal.GiveUp("the disk is full");
            Progress(journal, disk);
            disk.Room = 1000;
            journal.Write(new JournalEnd(JobOutcome.Complete, "", 4, 0, 0, 9.0, LeftAsFound: true));
        }

        Assert.Equal(["found", "job", "givenUp", "end"], JobJournal.ReadLines(path).Select(line => JsonSerializer.Deserialize<JsonElement>(line).GetProperty("kind").GetString()));
        var told = InterruptedJob.Read(path)!;
        File.Delete(path);
        Assert.Equal(("the disk is full", "", 0), (told.GivenUp, told.Fault, told.Place.Segments));
    }

    [Fact]
    public void A_journal_in_which_not_even_that_has_room_tells_of_no_job()
    {
        var path = Path.GetTempFileName();
        using (var disk = new FullDisk(path))
        using (var journal = new JobJournal(disk))
        {
            Begin(journal);
            disk.Room = 10;
            Progress(journal, disk);
            journal.GiveUp("the disk is full");
        }

        Assert.Equal(["found"], JobJournal.ReadLines(path).Select(line => JsonSerializer.Deserialize<JsonElement>(line).GetProperty("kind").GetString()));
        Assert.Null(InterruptedJob.Read(path));
        File.Delete(path);
    }

    private static void Begin(JobJournal journal)
    {
        journal.Write(new JournalFound("sim:", "DMC2143", 1, new FoundState(new WireState(null, null, null, null, null, null), [], "")));
        journal.BeginJob();
        journal.Write(new JournalHeader("part.dxf", "DMC2143", JobMode.Stream, 4, 0, 0, 0, 0, DateTimeOffset.UnixEpoch));
        journal.Keep();
    }

    private static void Progress(JobJournal journal, FullDisk disk)
    {
        try
        {
            journal.Write(new JournalProgress(0, 0, 0, 3, 10, 10, 1.0) { Cut = 3 });
        }
        catch (IOException)
        {
            disk.Room = 0;
        }
    }

    /// <summary>A file on a disk with room for a limited number of further bytes; existing content can be overwritten.</summary>
    private sealed class FullDisk(string path) : FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite, bufferSize: 0)
    {
        public long Room { get; set; } = 2000;

        public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            var fits = (int)Math.Min(buffer.Length, Length - Position + Room);
            var (before, taken) = (Length, buffer[..fits].ToArray());
            base.Write(taken, 0, taken.Length);
            Room -= Length - before;
            if (fits < buffer.Length) throw new IOException("the disk is full");
        }
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
