namespace Engraver.Core.Machines.Moves;

/// <summary>A range of counts of one axis; both ends are reached.</summary>
public readonly record struct CountsRange(long Min, long Max)
{
    public CountsRange With(long counts) => new(Math.Min(Min, counts), Math.Max(Max, counts));
}
