using System.Text;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Protocol;

/// <summary>Text that follows a command up to an end mark and is answered with a prompt only after it: a program (DL) or the elements of an array (QD)
/// (galil-dmc.md A.6).</summary>
internal sealed class TextReception(Handle handle, ICommandSink sink)
{
    private readonly StringBuilder _received = new();
    private Action<string>? _arrayTarget;
    private bool _isProgram;
    private bool _hasFailed;

    /// <summary>The end mark has not been received yet.</summary>
    public bool IsOpen => _isProgram || _arrayTarget is not null;

    public void BeginProgram()
    {
        _isProgram = true;
        _hasFailed = false;
        _received.Clear();
    }

    /// <param name="store">Called with the whole text at its end.</param>
    public void BeginArray(Action<string> store)
    {
        _arrayTarget = store;
        _received.Clear();
    }

    /// <returns>True for the end mark; <see cref="End"/> must then be called.</returns>
    public bool Accept(char c)
    {
        var isEnd = c is '\\' or '\x1A' || (_isProgram && c is '\x11' or '\x04');
        if (_isProgram && (c == '\r' || isEnd)) EndLine();
        else if (!isEnd && _received.Length < Longest) _received.Append(c); // longer text is refused at its end and need not be stored
        return isEnd;
    }

    /// <returns>The answer to the whole text; null when no answer is sent.</returns>
    public string? End()
    {
        if (_isProgram)
        {
            _isProgram = false;
            return sink.EndDownload(_hasFailed);
        }

        var store = _arrayTarget!;
        _arrayTarget = null;
        return sink.StoreArray(handle, () => store(_received.Length < MemorySizes.LongestArray ? _received.ToString() : throw new CommandRefusedException(Tc.TooManyElements)));
    }

    private int Longest => _isProgram ? MemorySizes.LongestLine + 1 : MemorySizes.LongestArray;

    private void EndLine()
    {
        var line = _received.ToString();
        _received.Clear();
        if (_hasFailed || sink.StoreLine(line)) return;
        _hasFailed = true;
        handle.SendText("?");
    }
}
