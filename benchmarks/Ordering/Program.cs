using System.Globalization;
using Engraver.Benchmarks.Ordering;

CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
switch (args)
{
    case ["table", var seconds, .. var names]:
        OrderTable.Write(double.Parse(seconds, CultureInfo.InvariantCulture), names.Length > 0 ? names : OrderInstances.Names);
        return 0;
    case ["curve", var steps, .. var instances]:
        foreach (var name in instances) OrderTable.WriteCurve(long.Parse(steps, CultureInfo.InvariantCulture), name);
        return 0;
    case ["reference", var trials, .. var instances]:
        foreach (var name in instances) OrderTable.WriteReference(long.Parse(trials, CultureInfo.InvariantCulture), name);
        return 0;
    default:
        Console.Error.WriteLine(
            """
            usage: Engraver.OrderBenchmark table SECONDS [INSTANCE...]
                     print travel and processor time of each order; SECONDS of search on two cores, 0 for none
                   Engraver.OrderBenchmark curve STEPS INSTANCE...
                     print travel over processor time for numbers of steps that double up to STEPS
                   Engraver.OrderBenchmark reference TRIALS INSTANCE...
                     print the travel that the reference solver reaches
            """);
        return 2;
}
