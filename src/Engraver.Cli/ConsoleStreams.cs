using System.Text;

namespace Engraver.Cli;

/// <summary>Where a run of the program writes: results to <see cref="Out"/> (UTF-8, LF), everything a person reads beside them to
/// <see cref="Error"/>.</summary>
/// <param name="output">Standard output.</param>
/// <param name="error">Standard error.</param>
/// <param name="input">Standard input; null: none is read.</param>
public sealed class ConsoleStreams(Stream output, TextWriter error, TextReader? input = null) : IDisposable
{
    private volatile bool _abandoned;

    public TextWriter Out { get; } = new StreamWriter(output, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), bufferSize: 65536) { NewLine = "\n" };

    public TextWriter Error { get; } = error;

    public TextReader In { get; } = input ?? TextReader.Null;

    /// <summary>True when a person sits at both ends: keys are read one by one and replies are coloured.</summary>
    public bool Interactive { get; init; }

    /// <summary>Takes the next key that was pressed, without waiting; null where nobody has keys.</summary>
    public Func<ConsoleKeyInfo?>? Keys { get; init; }

    /// <summary>For a verb that was left behind and may still be writing: what is buffered is dropped, and disposing does not wait.</summary>
    public void Abandon() => _abandoned = true;

    /// <summary>What could not be written has been said when it was flushed.</summary>
    public void Dispose()
    {
        if (_abandoned) return;
        try
        {
            Out.Dispose();
        }
        catch (IOException)
        {
            // The place is full or gone: disposing tries once more, in vain.
        }
    }
}
