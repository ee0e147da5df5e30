namespace Engraver.Core.Machines.Moves;

/// <summary>The jobs that follow one in a series. It is not started if one of them could not be.</summary>
/// <param name="Here">What they reach at its own place; null for none, and where the travel is not limited.</param>
/// <param name="Elsewhere">The names of the other work origins at which they are cut, each once, with what they reach there; null where the travel is not
/// limited.</param>
public sealed record FollowingJobs(MotionExtents? Here, IReadOnlyList<(string Origin, MotionExtents? Reached)> Elsewhere);
