namespace Engraver.Simulator.Protocol;

/// <summary>The controller's main serial port (galil-dmc.md A.2): one client, echo until EO 0, every byte takes ten bits at the baud rate.</summary>
internal sealed class SerialPort
{
    /// <summary><c>_WH</c> of the port, which is not in the handle table (A.1).</summary>
    public const int HandleIndex = -1;

    private volatile bool _isInstant;

    /// <summary>EO: 1 is the factory setting; a reset restores the value burned by BN.</summary>
    public bool Echo { get; set; } = true;

    /// <summary>The connected client; null when there is none.</summary>
    public Handle? Client { get; set; }

    /// <summary>Start bit, eight data bits, stop bit.</summary>
    public TimeSpan ByteTime { get; private set; }

    /// <summary>True when bytes take no time on the line; can be read from any thread.</summary>
    public bool IsInstant
    {
        get => _isInstant;
        set => _isInstant = value;
    }

    /// <summary>Connects a client; returns null when a client is already connected.</summary>
    public Handle? Plug(int baud, Handle client)
    {
        if (Client is not null) return null;
        ByteTime = TimeSpan.FromSeconds(10.0 / baud);
        return Client = client;
    }
}
