using Engraver.Core.Sequencing;

namespace Engraver.Benchmarks.Ordering;

/// <summary>One order of an instance.</summary>
/// <param name="CpuSeconds">Processor time of the process for it.</param>
internal sealed record OrderFigure(SequencingResult Order, double CpuSeconds)
{
    /// <summary>There and back, mm.</summary>
    public double Travel => Order.TravelAndBack;
}
