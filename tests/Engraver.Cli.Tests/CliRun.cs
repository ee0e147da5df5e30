using System.Text;

namespace Engraver.Cli.Tests;

/// <summary>One run of the program inside the test process: with exit code and both outputs.</summary>
internal sealed record CliRun(int ExitCode, string Out, string Error)
{
    public static Task<CliRun> RunAsync(params string[] args) => RunAsync(CancellationToken.None, args);

    /// <param name="stop">Cancelling it is the operator's Ctrl-C.</param>
    /// <param name="args">The words after <c>engraver</c>.</param>
    public static Task<CliRun> RunAsync(CancellationToken stop, params string[] args) => Typing(TextReader.Null, stop, args);

    /// <summary>A run with a pipe for standard input.</summary>
    public static Task<CliRun> Typing(string input, params string[] args) => Typing(new StringReader(input), CancellationToken.None, args);

    public static async Task<CliRun> Typing(TextReader input, CancellationToken stop, params string[] args)
    {
        using var output = new MemoryStream();
        await using var error = new StringWriter();
        int code;
        using (var streams = new ConsoleStreams(output, error, input))
        {
            code = await EngraverProgram.RunAsync(args, streams, stop);
        }

        return new CliRun(code, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
    }
}
