namespace Engraver.Core.Posts;

/// <summary>Progress of a replay.</summary>
/// <param name="Chunk">Number of the current chunk, from 1.</param>
/// <param name="Chunks">Number of chunks.</param>
/// <param name="MachineTime">Controller time so far.</param>
/// <param name="Expected">Controller time that the whole is expected to take; zero when no motion is expected.</param>
public readonly record struct ReplayProgress(int Chunk, int Chunks, TimeSpan MachineTime, TimeSpan Expected)
{
    /// <summary>0 to 1, never decreasing: the larger of the fraction of completed programs and the fraction of the time.</summary>
    public double Fraction => Math.Max((Chunk - 1.0) / Chunks, Expected > TimeSpan.Zero ? Math.Min(1.0, MachineTime / Expected) : 0.0);
}
