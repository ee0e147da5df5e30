namespace Engraver.Galil.Links;

/// <summary>What a serial line means for those who talk over it: one wire for everything, characters echoed while EO is 1, and every byte takes its time.</summary>
/// <param name="Baud">Bits per second; one of <see cref="Rates"/>.</param>
public sealed record SerialLine(int Baud)
{
    /// <summary>The rates of galil-dmc.md A.2.</summary>
    public static IReadOnlyList<int> Rates { get; } = [1200, 9600, 19200, 38400, 57600, 115200];

    /// <summary>Seconds a byte takes: a start bit, eight data bits, a stop bit.</summary>
    public double ByteSeconds => 10.0 / Baud;

    /// <summary>Seconds that a number of bytes take.</summary>
    public TimeSpan Time(long bytes) => TimeSpan.FromSeconds(bytes * ByteSeconds);
}
