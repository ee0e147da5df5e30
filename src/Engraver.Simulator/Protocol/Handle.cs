using System.Text;
using Engraver.Simulator.Language;

namespace Engraver.Simulator.Protocol;

/// <summary>One connection: cuts the incoming bytes into commands and gives every command its prompt (galil-dmc.md A.3, A.6, L.2).</summary>
/// <remarks>All members are called under the controller's lock, except that <see cref="Output"/> may be read by anyone.</remarks>
internal sealed class Handle(int index, int localPort, int remotePort, ICommandSink sink)
{
    private const int LongestLine = 80;
    private readonly StringBuilder command = new();
    private readonly StringBuilder download = new();
    private int lineLength;
    private bool quoted;
    private bool swallowReturn;
    private Action<string>? arrayTarget;
    private bool downloading;
    private bool downloadFailed;

    public int Index => index;

    /// <summary>The main serial port, which is no handle of the table (A.1: <c>_WH</c> is -1).</summary>
    public bool IsSerial => index == SerialPort.HandleIndex;

    public string Name => IsSerial ? "RS232" : "IH" + (char)('A' + index);

    public int LocalPort => localPort;

    public int RemotePort => remotePort;

    /// <summary>What the controller sends to this client.</summary>
    public ByteQueue Output { get; } = new();

    /// <summary>Commands received on this handle.</summary>
    public long Commands { get; private set; }

    public bool IsClosed { get; private set; }

    /// <summary>Cuts the connection from the controller's side.</summary>
    public Action? Disconnect { get; set; }

    /// <summary>Inside a download: the command gets no prompt before its text has ended.</summary>
    public bool IsReceivingText => downloading || arrayTarget is not null;

    private bool closeAfterReply;

    public void Receive(ReadOnlySpan<byte> bytes)
    {
        foreach (byte b in bytes)
        {
            if (IsClosed)
            {
                return;
            }

            sink.Arrived(this, b);
            Accept((char)b);
        }
    }

    public void Send(ReadOnlySpan<byte> bytes)
    {
        if (!IsClosed)
        {
            sink.Deliver(this, bytes);
        }
    }

    /// <summary>Closes now, or behind the prompt of the running command when it is this handle's own.</summary>
    public void CloseWhenAnswered(bool own)
    {
        if (own)
        {
            closeAfterReply = true;
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
            sink.Closed(this);
            Output.Complete();
        }
    }

    /// <summary>Frees the handle and breaks the line at once.</summary>
    public void Cut()
    {
        Disconnect?.Invoke(); // first: a closed handle would end its socket politely
        Close();
    }

    public void BeginDownload()
    {
        downloading = true;
        downloadFailed = false;
        download.Clear();
    }

    public void BeginArrayDownload(Action<string> store)
    {
        arrayTarget = store;
        download.Clear();
    }

    private void Accept(char c)
    {
        if (c == '\n')
        {
            return;
        }

        bool afterTerminator = swallowReturn;
        swallowReturn = false;
        if (downloading)
        {
            AcceptProgram(c);
        }
        else if (arrayTarget is not null)
        {
            AcceptArray(c);
        }
        else if (c == '\r')
        {
            // A CR behind the terminator of a download belongs to it (L.2 point 3).
            if (!afterTerminator)
            {
                EndLine();
            }
        }
        else
        {
            AcceptCommand(c);
        }
    }

    private void AcceptCommand(char c)
    {
        lineLength++;
        if (lineLength > LongestLine)
        {
            return;
        }

        quoted ^= c == '"';
        if (c == ';' && !quoted)
        {
            RunCommand();
        }
        else
        {
            command.Append(c);
        }
    }

    private void EndLine()
    {
        bool tooLong = lineLength > LongestLine;
        lineLength = 0;
        quoted = false;
        if (tooLong)
        {
            command.Clear();
            Answer(sink.Refuse(this, Tc.InputBufferFull));
        }
        else
        {
            RunCommand();
        }
    }

    private void RunCommand()
    {
        string text = command.ToString();
        command.Clear();
        Answer(sink.Execute(this, text));
    }

    /// <summary>A null reply means silence: a download begins, or the controller is frozen.</summary>
    private void Answer(string? reply)
    {
        Commands++;
        if (reply is not null)
        {
            SendText(reply);
        }

        sink.Answered(this, reply?.Length ?? 0);
        if (closeAfterReply)
        {
            Close();
        }
    }

    private void SendText(string text)
    {
        Span<byte> bytes = text.Length <= 512 ? stackalloc byte[text.Length] : new byte[text.Length];
        Encoding.Latin1.GetBytes(text, bytes);
        Send(bytes);
    }

    private void AcceptProgram(char c)
    {
        bool end = c is '\\' or '\x1A' or '\x11' or '\x04';
        if (c == '\r' || end)
        {
            EndProgramLine();
        }
        else
        {
            download.Append(c);
        }

        if (end)
        {
            downloading = false;
            swallowReturn = true;
            Answer(sink.EndDownload(downloadFailed));
        }
    }

    private void EndProgramLine()
    {
        string line = download.ToString();
        download.Clear();
        if (!downloadFailed && !sink.StoreLine(line))
        {
            downloadFailed = true;
            SendText("?");
        }
    }

    private void AcceptArray(char c)
    {
        if (c is not ('\\' or '\x1A'))
        {
            download.Append(c);
            return;
        }

        var store = arrayTarget!;
        arrayTarget = null;
        swallowReturn = true;
        Answer(sink.StoreArray(this, () => store(download.ToString())));
    }
}
