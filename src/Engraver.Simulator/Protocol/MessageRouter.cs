namespace Engraver.Simulator.Protocol;

/// <summary>Sends the output of programs to the port that CF names, with bit 7 set under CW 1 (galil-dmc.md A.5).</summary>
internal sealed class MessageRouter(HandleTable handles, SerialPort serial, SimulatorOptions options)
{
    private const int Marked = 1;

    /// <summary>A to H, or S (factory setting) for the serial port, where no host on Ethernet receives messages.</summary>
    public char Port { get; set; } = options.MessagePort;

    /// <summary>CW, first field: 1 sets bit 7, 2 (factory setting) does not.</summary>
    public int Marking { get; set; } = options.MessageMarking;

    /// <summary>CW, second field.</summary>
    public int WhenBlocked { get; set; } = 1;

    /// <summary>CF is not burned: every reset restores the port of the options.</summary>
    public void Reset() => Port = options.MessagePort;

    /// <param name="handle">The handle that {Ex} named; null selects the port of CF, -1 is the serial port.</param>
    /// <returns>False when the receiving client has disconnected without the controller detecting it (#TCPERR, C.3).</returns>
    public bool Send(ReadOnlySpan<char> text, int? handle)
    {
        var index = handle ?? (Port == 'S' ? -1 : Port - 'A');
        if (index >= handles.Capacity) return true;
        if ((index < 0 ? serial.Client : handles[index]) is not { } target) return index < 0 || !handles.NoticeLoss(index);

        var mark = Marking == Marked ? (byte)0x80 : (byte)0;
        Span<byte> bytes = text.Length <= 256 ? stackalloc byte[text.Length] : new byte[text.Length];
        for (var i = 0; i < bytes.Length; i++) bytes[i] = (byte)(text[i] | mark);

        target.Send(bytes);
        return true;
    }
}
