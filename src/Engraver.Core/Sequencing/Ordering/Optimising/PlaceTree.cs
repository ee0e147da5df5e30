using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Places of nodes in a k-d tree without pointers, for the nodes nearest to a place.</summary>
internal sealed class PlaceTree
{
    private const int LeafSize = 8;
    private readonly (double X, double Y, int Node)[] _items;

    public PlaceTree(OrderProblem problem)
    {
        var items = new List<(double, double, int)>();
        for (var node = 0; node < problem.Count; node++)
        {
            foreach (var place in problem.PlacesOf(node))
            {
                if (!double.IsNaN(place.X)) items.Add((place.X, place.Y, node));
            }
        }

        _items = [.. items];
        Build(0, _items.Length, byX: true);
    }

    /// <summary>Enters the nearest nodes into a list that may have some already.</summary>
    public void Nearest(Point2D place, NearList near) => Search(0, _items.Length, byX: true, place, near);

    private void Build(int first, int end, bool byX)
    {
        while (end - first > LeafSize)
        {
            var middle = (first + end) / 2;
            Select(first, end - 1, middle, byX);
            Build(first, middle, !byX);
            (first, byX) = (middle + 1, !byX);
        }
    }

    /// <summary>Puts the item of a rank at its position, smaller ones before it and larger ones behind it.</summary>
    private void Select(int first, int last, int rank, bool byX)
    {
        while (first < last)
        {
            var pivot = _items[(first + last) / 2];
            var (low, high) = (first, last);
            while (low <= high)
            {
                while (Compare(_items[low], pivot, byX) < 0) low++;
                while (Compare(_items[high], pivot, byX) > 0) high--;
                if (low > high) break;
                (_items[low], _items[high]) = (_items[high], _items[low]);
                (low, high) = (low + 1, high - 1);
            }

            if (rank <= high) last = high;
            else if (rank >= low) first = low;
            else return;
        }
    }

    /// <summary>A total order, so that the tree is the same for every order of the input.</summary>
    private static int Compare(in (double X, double Y, int Node) a, in (double X, double Y, int Node) b, bool byX)
    {
        var (first, second) = byX ? (a.X.CompareTo(b.X), a.Y.CompareTo(b.Y)) : (a.Y.CompareTo(b.Y), a.X.CompareTo(b.X));
        return first != 0 ? first : second != 0 ? second : a.Node.CompareTo(b.Node);
    }

    private void Search(int first, int end, bool byX, Point2D place, NearList near)
    {
        while (end - first > LeafSize)
        {
            var middle = (first + end) / 2;
            var item = _items[middle];
            Offer(item, place, near);
            var off = byX ? place.X - item.X : place.Y - item.Y;
            if (off < 0.0)
            {
                Search(first, middle, !byX, place, near);
                if (off * off > near.Reach) return;
                (first, byX) = (middle + 1, !byX);
            }
            else
            {
                Search(middle + 1, end, !byX, place, near);
                if (off * off > near.Reach) return;
                (end, byX) = (middle, !byX);
            }
        }

        for (var i = first; i < end; i++) Offer(_items[i], place, near);
    }

    private static void Offer(in (double X, double Y, int Node) item, Point2D place, NearList near)
    {
        var (dx, dy) = (item.X - place.X, item.Y - place.Y);
        near.Offer(item.Node, dx, dy);
    }
}
