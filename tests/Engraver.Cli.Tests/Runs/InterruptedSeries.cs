using System.Text;

namespace Engraver.Cli.Tests.Runs;

/// <summary>A run of several plates that is interrupted in the third one.</summary>
internal static class InterruptedSeries
{
    /// <param name="begun">What is reported when the third plate begins.</param>
    /// <param name="interrupt">Called some reports after that.</param>
    public static async Task<CliRun> InPlateThreeAsync(string begun, Action<CancellationTokenSource> interrupt, string[] args)
    {
        using var output = new MemoryStream();
        await using var error = new StringWriter();
        using var stop = new CancellationTokenSource();
        var reports = 0;
        int code;
        using (var streams = new ConsoleStreams(output, error, new StringReader("\n\n\n\n"))
        {
            Keys = () =>
            {
                if (error.ToString().Contains(begun, StringComparison.Ordinal) && ++reports == 20) interrupt(stop);
                return null;
            },
        })
        {
            code = await EngraverProgram.RunAsync(args, streams, stop.Token);
        }

        return new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
    }
}
