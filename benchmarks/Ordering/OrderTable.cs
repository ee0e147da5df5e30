using System.Diagnostics;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Sequencing.Ordering.Optimising;

namespace Engraver.Benchmarks.Ordering;

/// <summary>The table of docs/benchmarks.md: travel of each order over the best that is known.</summary>
internal static class OrderTable
{
    private const int Cores = 2;

    public static void Write(double seconds, IReadOnlyList<string> names)
    {
        Console.WriteLine("| Instance | Best known, mm | drawn | nearest | CPU s | optimal | CPU s | optimal by time | CPU s | violations |");
        Console.WriteLine("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        foreach (var name in names) Write(OrderInstances.Make(name), seconds);
    }

    /// <summary>The travel over the processor time of a search with more and more steps.</summary>
    public static void WriteCurve(long steps, string name)
    {
        var (chained, _) = OrderInstances.Make(name).Chain();
        for (var tried = steps / 64; tried <= steps; tried *= 4)
        {
            var figure = Measure(chained, OrderInstance.Options with { Order = StrokeOrder.Optimal, Search = new OrderSearch { Steps = tried } });
            Console.WriteLine($"| {name} | {tried} | {figure.CpuSeconds:0.00} | {figure.Travel:0.000} | {figure.Travel / BestKnown.Of(name):0.000} |");
        }
    }

    /// <summary>The travel of the reference solver, with ten times as many trials each time.</summary>
    public static void WriteReference(long trials, string name)
    {
        var instance = OrderInstances.Make(name);
        var (chained, shapeOf) = instance.Chain();
        int[] order = [.. Sequencer.Order(chained, OrderInstance.Options).Strokes.Select(stroke => shapeOf[stroke.Moves[0].EntityIndex])];
        for (var tried = trials / 100; tried <= trials; tried *= 10)
        {
            var travel = new ReferenceSolver(instance, order, seed: 1).Run(tried);
            Console.WriteLine($"| {name} | {tried} | {travel:0.000} | {travel / BestKnown.Of(name):0.000} |");
        }
    }

    private static void Write(OrderInstance instance, double seconds)
    {
        var (chained, shapeOf) = instance.Chain();
        var drawn = Measure(chained, OrderInstance.Options with { Order = StrokeOrder.Drawn });
        var nearest = Measure(chained, OrderInstance.Options);
        var steps = Measure(chained, OrderInstance.Options with { Order = StrokeOrder.Optimal });
        OrderFigure[] figures = seconds > 0.0 ? [drawn, nearest, steps, MeasureTime(chained, seconds)] : [drawn, nearest, steps];
        var best = Math.Min(BestKnown.Of(instance.Name), figures.Min(figure => figure.Travel));
        Console.Write($"| {instance.Name} | {best:0.000} | {drawn.Travel / best:0.00} |");
        foreach (var figure in figures.Skip(1)) Console.Write($" {figure.Travel / best:0.000} | {figure.CpuSeconds:0.00} |");
        Console.WriteLine($" {figures.Sum(figure => OrderJudge.Violations(instance, shapeOf, figure.Order))} |");
    }

    private static OrderFigure MeasureTime(ChainedTable chained, double seconds)
    {
        using var stop = new CancellationTokenSource(TimeSpan.FromSeconds(seconds));
        return Measure(chained, OrderInstance.Options with { Order = StrokeOrder.Optimal, Search = new OrderSearch { Steps = long.MaxValue, Searches = Cores, Stop = stop.Token } });
    }

    private static OrderFigure Measure(ChainedTable chained, SequencingOptions options)
    {
        using var process = Process.GetCurrentProcess();
        var before = process.TotalProcessorTime;
        var order = Sequencer.Order(chained, options);
        process.Refresh();
        return new OrderFigure(order, (process.TotalProcessorTime - before).TotalSeconds);
    }
}
