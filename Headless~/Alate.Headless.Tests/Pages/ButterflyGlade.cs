using Alate;
using Alate.Catalogue;
using Alate.Flight;
using UnityEngine;

/// <summary>A glade with butterflies that wander, land on flowers, bask, and flee from the player.</summary>
public sealed class ButterflyGlade : MonoBehaviour
{
    [SerializeField] private Transform m_Player;
    [SerializeField] private Transform[] m_Flowers = { };
    [SerializeField] private int m_Count = 5;

    private int m_Sitting;

    /// <summary>Sets the glade up from another script, before it starts.</summary>
    public void SetUp(Transform player, Transform[] flowers, int count)
    {
        m_Player = player;
        m_Flowers = flowers;
        m_Count = count;
    }

    /// <summary>Number of butterflies that sit now.</summary>
    public int Sitting => m_Sitting;

    private void Start()
    {
        // The feet are set down on the mark's origin, the back to its up.
        foreach (Transform flower in m_Flowers)
            flower.gameObject.AddComponent<PerchMark>();
        for (int number = 0; number < m_Count; number++)
            Add(number);
    }

    private void Add(int number)
    {
        InsectDefinition species = InsectCatalogue.Find(number % 2 == 0 ? "monarch" : "swallowtail");
        InsectWings wings = InsectFactory.Create(species, InsectVariant.Flight);
        wings.transform.SetParent(transform, false);
        wings.transform.localPosition = new Vector3(2f * (number % 3 - 1), 2f + 0.5f * (number % 4), 2f * (number / 3 % 3 - 1));
        InsectFlight flight = CatalogueFlight.AddTo(wings, species);

        // The first pilot decides; the perch pilot asks the one below it for the way between two flowers.
        PerchPilot perch = wings.gameObject.AddComponent<PerchPilot>();
        perch.Seed = number + 1;
        perch.Settings.flightTime = 6f;
        perch.Settings.stayTime = 8f;
        perch.Settings.fleeDistance = 3f;
        perch.Watched.Add(m_Player);
        WanderPilot wander = wings.gameObject.AddComponent<WanderPilot>();
        wander.Seed = number + 1;
        wander.Volume = new FlightVolume(VolumeShape.Box, transform.position + 3f * Vector3.up, new Vector3(14f, 4f, 14f));

        flight.Landed += _ => m_Sitting++;
        flight.TookOff += _ => m_Sitting--;
    }
}
