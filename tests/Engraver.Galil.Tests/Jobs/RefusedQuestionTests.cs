using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A controller that does not support an operand that a job needs refuses the query: the job reports a refusal, and the link is not lost.</summary>
public class RefusedQuestionTests
{
    private static readonly string[] s_operands = ["_BGS", "_BGA", "_BGB", "_CSS", "seq", "_VMS", "_RPA", "_RPB", "TIME", "_SCA", "_XQ0", "_XQ1", "errcode", "wtrip", "_OP0"];

    [Theory]
    [InlineData(JobMode.Stream, 0)]
    [InlineData(JobMode.Calls, 0)]
    [InlineData(JobMode.Program, 0)]
    [InlineData(JobMode.Stream, 19200)]
    [InlineData(JobMode.Program, 19200)]
    public async Task Whichever_operand_is_not_known_the_job_ends_as_refused_and_at_rest(JobMode mode, int baud)
    {
        foreach (var operand in s_operands)
        {
            await using var bench = new SimulatedBench();
            var unknown = "_" + new string('Z', operand.Length - 1);
            string Harm(string line) => line.StartsWith("MG ", StringComparison.Ordinal) && line.IndexOf('\r') == line.Length - 1 ? line.Replace(operand, unknown, StringComparison.Ordinal) : line; // not part of a download
            string Mend(string heard) => heard.Replace(unknown, operand, StringComparison.Ordinal); // the echo on a serial line
            await using var session = baud == 0 ? await bench.OpenAsync(opened: link => link.Corrupt = Harm) : await bench.OpenSerialAsync(baud, harm: Harm, mend: Mend);

            var result = await JobRunner.RunAsync(MotionPrograms.Paper, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, null, CancellationToken.None);

            Assert.Equal((operand, JobOutcome.Refused, ""), (operand, result.Outcome, result.Outcome == JobOutcome.Refused ? "" : result.Message));
            Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
        }
    }
}
