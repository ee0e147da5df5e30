using System.Globalization;
using Engraver.Benchmarks;

// usage: Engraver.Benchmarks [ENTITIES ...]     (default 1000 10000 100000)
int[] sizes = args.Length == 0 ? [1_000, 10_000, 100_000] : [.. args.Select(word => int.Parse(word, CultureInfo.InvariantCulture))];
using var stop = new CancellationTokenSource();
Console.CancelKeyPress += (_, pressed) =>
{
    pressed.Cancel = true;
    stop.Cancel();
};

Console.WriteLine("| Entities | Stage | CPU s (median) | allocated bytes/entity | kept bytes/entity | note |");
Console.WriteLine("|---:|---|---:|---:|---:|---|");
await StageBenchmark.WarmUpAsync(stop.Token).ConfigureAwait(false);
foreach (var size in sizes)
{
    foreach (var row in await StageBenchmark.RunAsync(size, stop.Token).ConfigureAwait(false)) Console.WriteLine(row.ToMarkdown());
}
