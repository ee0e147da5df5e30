using System.Text;

namespace Engraver.Cli;

/// <summary>Where a run of the program writes: results to <see cref="Out"/> (UTF-8, LF), everything a person reads beside them to <see cref="Error"/>.</summary>
public sealed class ConsoleStreams(Stream output, TextWriter error) : IDisposable
{
    public TextWriter Out { get; } = new StreamWriter(output, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), bufferSize: 65536) { NewLine = "\n" };

    public TextWriter Error { get; } = error;

    public void Dispose() => Out.Dispose();
}
