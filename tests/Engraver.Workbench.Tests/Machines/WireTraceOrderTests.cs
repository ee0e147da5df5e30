using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>The trace of a run ends after its session: it includes the commands that restore the controller.</summary>
public sealed class WireTraceOrderTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-test-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public async Task The_last_words_of_the_session_are_in_the_trace()
    {
        var job = MachineBench.Job();
        var path = Path.Combine(_folder.FullName, "trace.txt");
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), JobMode.Stream.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "run.jsonl"), TracePath = path };
        var report = await MachineRun.RunAsync(job, job.Motion.Program!, options, TimeProvider.System, null, CancellationToken.None);
        var lines = (await File.ReadAllLinesAsync(path)).Select(line => line[(line.IndexOf(' ', StringComparison.Ordinal) + 1)..]).ToList();

        Assert.Null(report.TraceFailure);
        Assert.StartsWith("A > VF ", lines[^6], StringComparison.Ordinal); // number format, port and mark of messages: the session's own settings, restored when it is closed
        Assert.Equal(["A < :", "A > CF S", "A < :", "A > CW 2", "A < :"], lines[^5..]);
    }
}
