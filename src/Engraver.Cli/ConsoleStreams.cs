using System.Text;

namespace Engraver.Cli;

/// <summary>Where a run of the program writes: results to <see cref="Out"/> (UTF-8, LF), all other messages to <see cref="Error"/>.</summary>
/// <param name="output">Standard output.</param>
/// <param name="error">Standard error.</param>
/// <param name="input">Standard input; null: none is read.</param>
public sealed class ConsoleStreams(Stream output, TextWriter error, TextReader? input = null) : IDisposable
{
    private volatile bool _abandoned;

    public TextWriter Out { get; } = new StreamWriter(output, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), bufferSize: 65536) { NewLine = "\n" };

    public TextWriter Error { get; } = error;

    public TextReader In { get; } = input ?? TextReader.Null;

    /// <summary>True when input and output are interactive terminals: keys are read one by one and replies are coloured.</summary>
    public bool Interactive { get; init; }

    /// <summary>Returns the next pressed key without waiting. Null without an interactive terminal.</summary>
    public Func<ConsoleKeyInfo?>? Keys { get; init; }

    /// <summary>Called when a verb was abandoned and may still be writing: drops buffered output, and disposing does not wait.</summary>
    public void Abandon() => _abandoned = true;

    /// <summary>Write failures were reported when the stream was flushed.</summary>
    public void Dispose()
    {
        if (_abandoned) return;
        try
        {
            Out.Dispose();
        }
        catch (IOException)
        {
            // The disk is full or the stream is closed: disposing flushes again and fails again.
        }
    }
}
