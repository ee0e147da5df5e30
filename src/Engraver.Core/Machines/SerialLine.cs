namespace Engraver.Core.Machines;

/// <summary>Properties of a serial line: one connection for all traffic, an echo of each character while EO is 1, and a transmission time for every
/// byte.</summary>
/// <param name="Baud">Bits per second; one of <see cref="Rates"/>.</param>
public sealed record SerialLine(int Baud)
{
    /// <summary>The rates of galil-dmc.md A.2.</summary>
    public static IReadOnlyList<int> Rates { get; } = [1200, 9600, 19200, 38400, 57600, 115200];

    /// <summary>Seconds for one byte: a start bit, eight data bits, a stop bit.</summary>
    public double ByteSeconds => 10.0 / Baud;

    /// <summary>Time between the last byte of a line and the first of the next, seconds: the controller executes the last statement (galil-dmc.md A.4) and the
    /// host takes the prompts. The other statements are executed while the next one arrives.</summary>
    public double TurnaroundSeconds { get; init; } = 0.002;

    /// <summary>Time for a number of bytes.</summary>
    public TimeSpan Time(long bytes) => TimeSpan.FromSeconds(bytes * ByteSeconds);
}
