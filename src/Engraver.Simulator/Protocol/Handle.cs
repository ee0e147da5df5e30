using System.Text;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Protocol;

/// <summary>One connection: divides the incoming bytes into commands and answers every command with its prompt (galil-dmc.md A.3, A.6, L.2).</summary>
/// <remarks>All members are called under the controller's lock, except that <see cref="Output"/> may be read from any thread.</remarks>
internal sealed class Handle
{
    private const int LongestCommand = 80;
    private readonly ICommandSink _sink;
    private readonly TextBuffer _command = new();
    private readonly TextReception _text;
    private readonly Queue<byte> _unread = new();
    private int _length;
    private bool _quoted;
    private bool _swallowReturn;
    private bool _closeAfterReply;
    private bool _isDecoding;

    public Handle(int index, int localPort, int remotePort, ICommandSink sink)
    {
        (Index, LocalPort, RemotePort, _sink) = (index, localPort, remotePort, sink);
        _text = new TextReception(this, sink);
    }

    public int Index { get; }

    /// <summary>The main serial port, which is not in the handle table (A.1: <c>_WH</c> is -1).</summary>
    public bool IsSerial => Index == SerialPort.HandleIndex;

    public string Name => IsSerial ? "RS232" : "IH" + (char)('A' + Index);

    public int LocalPort { get; }

    public int RemotePort { get; }

    /// <summary>The bytes that the controller sends to this client.</summary>
    public ByteQueue Output { get; } = new();

    /// <summary>Commands received on this handle.</summary>
    public long Commands { get; private set; }

    public bool IsClosed { get; private set; }

    /// <summary>Sends answers as datagrams (UDP); null for a connection.</summary>
    public SendDatagram? Datagrams { get; init; }

    public bool IsUdp => Datagrams is not null;

    /// <summary>Delivers bytes to the client immediately.</summary>
    public void Emit(ReadOnlySpan<byte> bytes)
    {
        if (Datagrams is null) Output.Write(bytes);
        else Datagrams(bytes);
    }

    /// <summary>Called to cut the connection from the controller's side.</summary>
    public Action? Disconnect { get; set; }

    /// <summary>A command has started and not ended: its host must still send the rest, or waits for an answer that cannot be sent.</summary>
    public bool IsMidCommand => _length > 0 || IsReceivingText || _isDecoding;

    /// <summary>Inside a download: the command gets no prompt before the end of its text.</summary>
    public bool IsReceivingText => _text.IsOpen;

    /// <summary>Takes bytes from the client; bytes that arrive while a command is decoded wait for its end.</summary>
    public void Receive(ReadOnlySpan<byte> bytes)
    {
        foreach (var b in bytes)
        {
            if (_isDecoding) _unread.Enqueue(b);
            else Take(b);
        }
    }

    /// <summary>Executes the command whose decode time has passed, and takes the bytes that arrived in the meantime.</summary>
    public void Resume()
    {
        _isDecoding = false;
        if (!IsClosed) CompleteCommand();
        while (!_isDecoding && _unread.TryDequeue(out var b)) Take(b);
    }

    public void Send(ReadOnlySpan<byte> bytes)
    {
        if (!IsClosed) _sink.Deliver(this, bytes);
    }

    /// <summary>Sends text without a prompt.</summary>
    public void SendText(ReadOnlySpan<char> text)
    {
        Span<byte> bytes = text.Length <= 512 ? stackalloc byte[text.Length] : new byte[text.Length];
        Encoding.Latin1.GetBytes(text, bytes);
        Send(bytes);
    }

    /// <summary>Closes now, or after the prompt of the running command if it was received on this handle.</summary>
    public void CloseWhenAnswered(bool own)
    {
        if (own)
        {
            _closeAfterReply = true;
        }
        else
        {
            Cut();
        }
    }

    /// <summary>Frees the handle; bytes already sent still reach the client.</summary>
    public void Close()
    {
        if (!IsClosed)
        {
            IsClosed = true;
            _sink.Closed(this);
            Output.Complete();
        }
    }

    /// <summary>Frees the handle and drops the connection at once.</summary>
    public void Cut()
    {
        Disconnect?.Invoke(); // first, because a handle that is closed earlier would end its socket in the regular way
        Close();
    }

    public void BeginDownload() => _text.BeginProgram();

    public void BeginArrayDownload(Action<string> store) => _text.BeginArray(store);

    private void Take(byte value)
    {
        if (!IsClosed && _sink.ByteReceived(this, value)) Accept((char)value);
    }

    private void Accept(char c)
    {
        if (c == '\n') return;

        var afterTerminator = _swallowReturn;
        _swallowReturn = false;
        if (_text.IsOpen)
        {
            if (_text.Accept(c)) EndText();
        }
        else if (c == '\r')
        {
            // A CR after the terminator of a download belongs to it (L.2 point 3).
            if (!afterTerminator) EndCommand();
        }
        else if (c == ';' && (!_quoted || _length > LongestCommand))
        {
            EndCommand();
        }
        else
        {
            Append(c);
        }
    }

    /// <summary>Appends to the command, up to the longest line. Beyond that length, a semicolon ends the command even inside an open quote: some clients never
    /// send a CR (L.1.2) and must still receive an answer.</summary>
    private void Append(char c)
    {
        if (++_length > LongestCommand) return;
        _quoted ^= c == '"';
        _command.Append(c);
    }

    /// <summary>CR and ";" both end a command, which is executed as soon as it is decoded (A.3).</summary>
    private void EndCommand()
    {
        if (_sink.DefersCommand(this)) _isDecoding = true;
        else CompleteCommand();
    }

    /// <summary>Executes the command; the buffer is then free for the next command.</summary>
    private void CompleteCommand()
    {
        var tooLong = _length > LongestCommand;
        _length = 0;
        _quoted = false;
        if (tooLong)
        {
            _command.Clear();
            Answer(_sink.Refuse(this, Tc.InputBufferFull));
        }
        else
        {
            RunCommand();
        }
    }

    private void RunCommand()
    {
        var reply = _sink.Execute(this, _command.Text);
        _command.Clear();
        Answer(reply);
    }

    /// <summary>An empty reply means that nothing is sent: a download starts, or the fault plan has frozen the controller.</summary>
    private void Answer(ReadOnlySpan<char> reply)
    {
        Commands++;
        if (reply.Length > 0) SendText(reply);

        _sink.ReplySent(this, reply.Length);
        if (_closeAfterReply) Close();
    }

    private void EndText()
    {
        _swallowReturn = true;
        Answer(_text.End());
    }
}
